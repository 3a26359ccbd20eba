#include "mpm/grid/migration.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

template <std::size_t dim>
std::string place(const std::array<double, dim>& x) {
  std::string text;
  for (double c : x) text += (text.empty() ? "(" : ", ") + std::to_string(c);
  return text + ") m";
}

}  // namespace

template <int dim>
Migration<dim>::Migration(StagePlan<dim>& plan)
    : plan_(plan),
      cell_(plan.provide_on_points({"cell", "c", "-", 1, Lifetime::step})),
      slot_(plan.provide_on_points({"slot", "k", "-", 1, Lifetime::step})),
      scratch_(plan.provide_on_points({"scratch", "", "-", 1, Lifetime::step})),
      counts_(plan.fields.grid.cell_count()),
      next_(plan.fields.grid.cell_count()) {}

template <int dim>
bool Migration<dim>::find_cells() {
  const auto& grid = plan_.fields.grid;
  const auto& points = plan_.fields.points;
  bool moved = false;
  for (const Block& block : points.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      const Vector<dim> x = points.position(p);
      const int cell = grid.find_cell(x, static_cast<int>(block.cell));
      if (cell < 0)
        throw StepFailed("a material point has left the mesh at " + place(x) +
                         ". Give the mesh empty cells there, or fix the side");
      if (grid.region(static_cast<std::size_t>(cell)) != grid.region(block.cell))
        throw StepFailed("a material point has moved into the cells of another soil at " + place(x) +
                         " (soils belong to cells in this version)");
      cell_[0][p] = cell;
      moved = moved || static_cast<std::size_t>(cell) != block.cell;
    }
  return moved;
}

template <int dim>
void Migration<dim>::find_slots() {
  const auto& grid = plan_.fields.grid;
  const std::size_t points = plan_.fields.points.size();
  std::ranges::fill(counts_, 0);
  for (std::size_t p = 0; p < points; ++p) ++counts_[static_cast<std::size_t>(cell_[0][p])];
  int regions = static_cast<int>(plan_.problem.soils.size());
  std::size_t first = 0;
  for (int region = 0; region < regions; ++region)
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
      if (grid.region(cell) == region) {
        next_[cell] = first;
        first += counts_[cell];
      }
  for (std::size_t p = 0; p < points; ++p)
    slot_[0][p] = static_cast<double>(next_[static_cast<std::size_t>(cell_[0][p])]++);
}

template <int dim>
void Migration<dim>::permute(Column& column) {
  const std::size_t points = column.size();
  for (int c = 0; c < column.spec().components; ++c) {
    for (std::size_t p = 0; p < points; ++p) scratch_[0][static_cast<std::size_t>(slot_[0][p])] = column[c][p];
    std::copy_n(scratch_[0], points, column[c]);
  }
}

template <int dim>
void Migration<dim>::run() {
  if (!find_cells()) return;
  find_slots();
  for (const auto& column : plan_.fields.points.columns.all())
    if (column->spec().lifetime == Lifetime::carried && column->allocated()) permute(*column);
  plan_.fields.points.set_counts(plan_.fields.grid, counts_);
}

template class Migration<2>;
template class Migration<3>;

}  // namespace wetfront::mpm
