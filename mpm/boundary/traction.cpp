#include "mpm/boundary/traction.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/skeleton_side.h"

namespace wetfront::mpm {

template <int dim>
TractionCondition<dim>::TractionCondition(StagePlan<dim>& plan, const Traction& spec)
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
  boundary_side(plan, spec.side, "a traction", spec.origin);  // there is soil behind it
  for (const auto& node : side_nodes(plan, spec.side, "a traction", spec.origin, true)) {
    Vector<dim> load{};
    for (const auto& plane : node.planes)
      for (int a = 0; a < dim; ++a)
        load[a] += plane.area * (spec.force[static_cast<std::size_t>(a)] - spec.pressure * plane.normal[a]);
    index_.push_back(node.index);
    load_.push_back(load);
  }
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
  for (std::size_t k = 0; k < index_.size(); ++k) {
    if (nodes_.empty(static_cast<std::size_t>(index_[k])))
      throw StepFailed(spec_.origin + ": the traction on side '" + spec_.side +
                       "' cannot act any more (the soil has left node " + std::to_string(index_[k]) +
                       " of it). Put the load on the free surface, which moves with the soil");
    for (int a = 0; a < dim; ++a) nodes_.force[a][index_[k]] += factor * load_[k][a];
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
