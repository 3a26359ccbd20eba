#include "mpm/grid/migration.h"

#include <algorithm>
#include <bit>
#include <cmath>

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
      position_(plan.require_on_points("position")),
      velocity_(plan.require_on_points("velocity")),
      scratch_(plan.provide_on_points({"scratch", "", "-", 1, Lifetime::step})),
      count_(plan.provide_on_run({"migration", "", "-", migration_counts})) {
  const meshes::Mesh& mesh = plan.problem.mesh;
  for (std::size_t a = 0; a < dim; ++a) {
    const auto [least, most] = std::ranges::minmax(mesh.nodes, {}, [a](const meshes::Point& node) { return node[a]; });
    const double hair = 1e-9 * (most[a] - least[a]);
    low_[a] = least[a] - hair, high_[a] = most[a] + hair;
  }
  plan.at_finish([this](meshes::FieldHistory& history) {
    history.counters["points that changed cells"] = count_[migration_crossings][0];
    history.counters["points held at the mesh border"] = count_[migration_held][0];
  });
}

template <int dim>
void Migration<dim>::prepare(std::size_t chunks) {
  leaving_.resize(chunks);
  // A point in eight at a time and cell: more than that would have to cross within one step of the stability limit.
  for (auto& list : leaving_) list.reserve(64 + plan_.fields.points.size() / (8 * chunks));
  movers_.reserve(64 + plan_.fields.points.size() / 8);
}

/// Spares the search through all cells for who has left a mesh by one of its outermost sides.
template <int dim>
bool Migration<dim>::beyond_mesh(const Vector<dim>& x) const {
  for (int a = 0; a < dim; ++a)
    if (x[a] < low_[a] || x[a] > high_[a]) return true;
  return false;
}

/// Where the point goes; false when it stays.
template <int dim>
bool Migration<dim>::find_cell(Mover& mover) {
  const auto& grid = plan_.fields.grid;
  const auto& points = plan_.fields.points;
  const std::size_t slot = points.first_slot(mover.from, mover.soil) + mover.index;
  const Vector<dim> x = points.position(slot);
  const int cell = beyond_mesh(x) ? -1 : grid.find_cell(x, static_cast<int>(mover.from));
  if (cell < 0 && !std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); }))
    throw StepFailed("a material point of cell " + std::to_string(mover.from) + " has moved to " + place(x) +
                     ": the motion of the skeleton has blown up");
  mover.to = cell >= 0 ? static_cast<std::size_t>(cell) : hold(mover.from, slot, x);
  const bool two_velocities =
      plan_.stage.liquid == LiquidScheme::implicit_drag || plan_.stage.liquid == LiquidScheme::explicit_drag;
  if (two_velocities && grid.region(mover.to) != mover.soil)
    throw StepFailed("a material point of soil '" + plan_.problem.soils[static_cast<std::size_t>(mover.soil)].name +
                     "' has moved into the cells of another at " + place(x) +
                     " (with two velocities the laws of water belong to cells). Use the scheme seepage, end the "
                     "stage before, or give both one soil");
  return mover.to != mover.from;
}

/// Puts a point that has left the mesh back onto its border; returns the cell. As few axes as possible are put back,
/// for the point may have entered a neighbour along another: a point that leaves through the base while it passes an
/// upright face of its cell goes on along the base.
template <int dim>
std::size_t Migration<dim>::hold(std::size_t cell, std::size_t slot, const Vector<dim>& x) {
  const auto& grid = plan_.fields.grid;
  const Vector<dim> xi = grid.local(cell, x);
  count_[migration_held][0] += 1;
  for (int most = 1; most <= dim; ++most)
    for (unsigned axes = 1; axes < (1u << dim); ++axes) {
      if (std::popcount(axes) != most) continue;
      Vector<dim> held = xi;
      for (int a = 0; a < dim; ++a)
        if (axes & (1u << a)) held[a] = std::clamp(xi[a], -1.0, 1.0);
      const Vector<dim> back = grid.place(cell, held);
      const int home = grid.find_cell(back, static_cast<int>(cell));
      if (home < 0) continue;
      for (int a = 0; a < dim; ++a) {
        position_[a][slot] = back[a];
        if (held[a] != xi[a]) stop_outward(slot, grid.face_normal(cell, held, a, xi[a] > 0));
      }
      return static_cast<std::size_t>(home);
    }
  return cell;
}

template <int dim>
void Migration<dim>::stop_outward(std::size_t slot, const Vector<dim>& normal) {
  double outward = 0;
  for (int a = 0; a < dim; ++a) outward += velocity_[a][slot] * normal[a];
  for (int a = 0; a < dim && outward > 0; ++a) velocity_[a][slot] -= outward * normal[a];
}

template <int dim>
void Migration<dim>::run() {
  movers_.clear();
  for (auto& list : leaving_) {
    for (Mover& mover : list)
      if (find_cell(mover)) movers_.push_back(mover);
    list.clear();
  }
  count_[migration_crossings][0] += static_cast<double>(movers_.size());
  plan_.fields.points.move(plan_.fields.grid, movers_, scratch_);
}

template class Migration<2>;
template class Migration<3>;

}  // namespace wetfront::mpm
