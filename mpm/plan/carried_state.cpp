#include "mpm/plan/carried_state.h"

namespace wetfront::mpm {

template <int dim>
Stored carried_state(const Fields<dim>& fields) {
  Stored out;
  const auto store = [&out](const ColumnSet& set, const std::string& kind, const auto& values_of) {
    for (const auto& column : set.all())
      if (column->spec().lifetime == Lifetime::carried && column->allocated())
        out[kind + "." + column->spec().name] = values_of(*column);
  };
  const auto all = [](const Column& c) { return std::vector<double>(c.values().begin(), c.values().end()); };
  store(fields.points.columns, "point", [&fields](const Column& c) { return fields.points.in_order(c); });
  store(fields.grid.columns, "node", all);
  store(fields.run, "run", all);
  const auto& counts = fields.points.count_of_cell();
  out["points per cell"].assign(counts.begin(), counts.end());
  return out;
}

template <int dim>
void restore_points(Fields<dim>& fields, const Stored& stored) {
  auto& points = fields.points;
  const auto found = stored.find("points per cell");
  if (found == stored.end() || found->second.size() != points.count_of_cell().size())
    throw CannotPlan(
        "cannot continue this run: its state has another number of cells than the problem (it belongs to "
        "another problem). Start the run anew");
  std::vector<std::size_t> counts(found->second.begin(), found->second.end());
  points.set_counts(fields.grid, counts);
  for (const char* name : {"position", "volume"}) {
    Column& column = points.columns.at(name);
    const auto kept = stored.find(std::string("point.") + name);
    if (kept != stored.end() &&
        kept->second.size() == points.size() * static_cast<std::size_t>(column.spec().components))
      points.put_in_order(kept->second, column);
  }
}

template Stored carried_state(const Fields<2>&);
template Stored carried_state(const Fields<3>&);
template void restore_points(Fields<2>&, const Stored&);
template void restore_points(Fields<3>&, const Stored&);

}  // namespace wetfront::mpm
