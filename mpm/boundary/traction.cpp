#include "mpm/boundary/traction.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/skeleton_side.h"

namespace wetfront::mpm {

template <int dim>
TractionCondition<dim>::TractionCondition(StagePlan<dim>& plan, const Traction& spec, int number)
    : plan_(plan), nodes_(plan), spec_(spec) {
  for (double time : spec.factor.time) plan.add_break(time);
  if (spec.side == free_surface) {
    if (plan.problem.skeleton.shape != ShapeFunctions::linear)
      throw CannotPlan(spec.origin +
                       ": a traction on the free surface with spline shape functions (its pieces know the nodes of the "
                       "mesh, splines have others). Use linear shape functions");
    surface_ = std::make_unique<Surface<dim>>(plan.fields.grid, plan.fields.points, plan.problem.mesh);
    return;
  }
  boundary_side(plan, spec.side, "a traction", spec.origin);     // there is soil behind it
  side_nodes(plan, spec.side, "a traction", spec.origin, true);  // and it is one that sides know
  load_ = &plan.provide_on_nodes({"traction " + std::to_string(number), "t A", dim == 2 ? "N/m" : "N", dim});
  plan.at_entry([this] { load_side(); });
  plan.at_ready([this] {
    for (std::size_t i = 0; i < load_->size(); ++i)
      for (int a = 0; a < dim; ++a)
        if ((*load_)[a][i] != 0) {
          index_.push_back(static_cast<int>(i));
          break;
        }
  });
}

template <int dim>
void TractionCondition<dim>::load_side() {
  load_->fill(0);
  for (const auto& node : side_nodes(plan_, spec_.side, "a traction", spec_.origin, true))
    for (const auto& plane : node.planes)
      for (int a = 0; a < dim; ++a)
        (*load_)[a][node.index] +=
            plane.area * (spec_.force[static_cast<std::size_t>(a)] - spec_.pressure * plane.normal[a]);
}

template <int dim>
void TractionCondition<dim>::add_force() {
  const double factor = factor_at(spec_.factor, loading_time(plan_));
  if (factor == 0) return;
  if (surface_ != nullptr)
    add_on_surface(factor);
  else
    add_on_side(factor);
}

template <int dim>
void TractionCondition<dim>::add_on_side(double factor) {
  for (const int i : index_) {
    if (nodes_.empty(static_cast<std::size_t>(i)))
      throw StepFailed(spec_.origin + ": the traction on side '" + spec_.side +
                       "' cannot act any more (the soil has left node " + std::to_string(i) +
                       " of it). Put the load on the free surface, which moves with the soil");
    for (int a = 0; a < dim; ++a) nodes_.force[a][i] += factor * (*load_)[a][i];
  }
}

template <int dim>
void TractionCondition<dim>::add_on_surface(double factor) {
  surface_->update();
  bool any = false;
  for (const SurfacePiece<dim>& piece : surface_->pieces()) {
    if (piece.border) continue;
    any = true;
    const double size = length<dim>(piece.area);
    const int* nodes = plan_.fields.grid.cell_nodes_of(piece.cell);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a)
        nodes_.force[a][nodes[i]] += factor * piece.weight[i] *
                                     (size * spec_.force[static_cast<std::size_t>(a)] - spec_.pressure * piece.area[a]);
  }
  if (!any)
    throw StepFailed(spec_.origin +
                     ": the traction on the free surface cannot act (the soil fills the mesh up to its border, so it "
                     "has none). Name a side of the mesh");
}

template class TractionCondition<2>;
template class TractionCondition<3>;

}  // namespace wetfront::mpm
