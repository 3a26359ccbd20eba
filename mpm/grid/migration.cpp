#include "mpm/grid/migration.h"

#include "mpm/boundary/skeleton_side.h"
#include "mpm/grid/column_vector.h"

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
  open_periodic_sides();
  plan.at_finish([this](meshes::FieldHistory& history) {
    if (faces_) history.counters["points handed to the periodic partner"] = count_[migration_handed][0];
    history.counters["points that changed cells"] = count_[migration_crossings][0];
    history.counters["points held at the mesh border"] = count_[migration_held][0];
  });
}

template <int dim>
void Migration<dim>::open_periodic_sides() {
  const auto& mesh = plan_.problem.mesh;
  const auto& grid = plan_.fields.grid;
  const auto number = [&mesh](const std::string& name) {
    return static_cast<int>(std::ranges::find(mesh.sides, name, &meshes::Side::name) - mesh.sides.begin());
  };
  for (const auto& boundary : plan_.problem.skeleton_boundary)
    if (const auto* pair = std::get_if<PeriodicSkeleton>(&boundary)) {
      const auto way = between_sides(mesh, pair->side, pair->partner, pair->origin);
      Vector<dim> there{}, back{};
      for (std::size_t a = 0; a < dim; ++a) there[a] = way[a], back[a] = -way[a];
      through_[number(pair->side)] = there;
      through_[number(pair->partner)] = back;
    }
  if (through_.empty()) return;
  mass_ = &plan_.require_on_points("mass");
  faces_ = std::make_unique<Faces<dim>>(grid, mesh);
  across_.assign(grid.cell_count() * cell_faces<dim>, -1);
  int near = -1;  // faces of a side follow each other
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int face = 0; face < cell_faces<dim>; ++face) {
      const auto found = faces_->neighbour(cell, face) < 0 ? through_.find(faces_->side(cell, face)) : through_.end();
      if (found == through_.end()) continue;
      Vector<dim> middle{};
      for (const int local : local_face<dim>(face))
        for (int a = 0; a < dim; ++a) middle[a] += grid.node(grid.cell_nodes_of(cell)[local])[a] / face_nodes<dim>;
      for (int a = 0; a < dim; ++a) middle[a] += found->second[a];
      near = grid.find_cell(middle, near);
      across_[cell * cell_faces<dim> + static_cast<std::size_t>(face)] = near;
    }
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
  int cell = beyond_mesh(x) ? -1 : grid.find_cell(x, static_cast<int>(mover.from));
  if (cell < 0 && !std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); }))
    throw StepFailed("a material point of cell " + std::to_string(mover.from) + " has moved to " + place(x) +
                     ": the motion of the skeleton has blown up");
  if (cell < 0 && faces_) cell = hand_over(mover.from, slot, x);
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

/// Of a point that has left through a periodic side: moves it to the partner and returns its cell there. -1: it left
/// elsewhere. In a corner it may pass two such sides at once.
template <int dim>
int Migration<dim>::hand_over(std::size_t cell, std::size_t slot, const Vector<dim>& x) {
  const auto& grid = plan_.fields.grid;
  const Vector<dim> xi = grid.local(cell, x);
  Vector<dim> way{};
  int start = -1;
  for (int face = 0; face < cell_faces<dim>; ++face) {
    const int image = across_[cell * cell_faces<dim> + static_cast<std::size_t>(face)];
    if (image < 0) continue;
    const auto corners = local_face<dim>(face);
    bool beyond = false;
    for (int a = 0; a < dim; ++a) {  // the axis across the face: all its nodes lie on one side
      const double sign = node_sign(corners[0], a);
      const bool here = std::ranges::all_of(corners, [&](int i) { return node_sign(i, a) == sign; });
      beyond = beyond || (here && sign * xi[a] > 1);
    }
    if (!beyond) continue;
    for (int a = 0; a < dim; ++a) way[a] += through_.at(faces_->side(cell, face))[a];
    start = image;
  }
  if (start < 0) return -1;
  Column* const began = plan_.fields.points.columns.find_allocated("initial position");
  Vector<dim> inside{};
  for (int a = 0; a < dim; ++a) {
    inside[a] = position_[a][slot] = x[a] + way[a];
    if (began != nullptr) (*began)[a][slot] += way[a];
    count_[migration_lifted][0] -= (*mass_)[0][slot] * plan_.problem.gravity[static_cast<std::size_t>(a)] * way[a];
  }
  count_[migration_handed][0] += 1;
  const int found = beyond_mesh(inside) ? -1 : grid.find_cell(inside, start);
  // It may have left through the top as well.
  return found >= 0 ? found : static_cast<int>(hold(static_cast<std::size_t>(start), slot, inside));
}

/// Puts a point that has left the mesh back to its border; returns the cell. As few axes as possible are put back,
/// for the point may have entered a neighbour along another: a point that leaves through the base while it passes an
/// upright face of its cell goes on along the base. A hair inside the border, as on it the nodes behind would take
/// nothing of a point that is alone in its cell: nodes of a body without mass, whose means are 0/0.
template <int dim>
std::size_t Migration<dim>::hold(std::size_t cell, std::size_t slot, const Vector<dim>& x) {
  constexpr double border = 1 - 1e-6;  // in coordinates of a cell, -1..1; N there keeps ten digits
  const auto& grid = plan_.fields.grid;
  const Vector<dim> xi = grid.local(cell, x);
  count_[migration_held][0] += 1;
  for (int most = 1; most <= dim; ++most)
    for (unsigned axes = 1; axes < (1u << dim); ++axes) {
      if (std::popcount(axes) != most) continue;
      Vector<dim> held = xi;
      for (int a = 0; a < dim; ++a)
        if (axes & (1u << a)) held[a] = std::clamp(xi[a], -border, border);
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
