#include "mpm/boundary/absorbing_side.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/skeleton_side.h"
#include "mpm/laws/linear_elastic.h"

#include <cmath>

namespace wetfront::mpm {

namespace {

/// rho c of compression and of shear waves in the soil behind a side.
struct Impedance {
  double normal, tangential;
};
Impedance impedance_of(const Soil& soil, const Origin& origin) {
  if (soil.law && std::holds_alternative<ModifiedCamClay>(*soil.law))
    throw CannotPlan(origin + ": an absorbing side borders soil '" + soil.name +
                     "' of Cam-Clay (its stiffness follows the stress, so waves have no one speed). Use another law "
                     "behind this side");
  const LinearElastic law(*soil.elastic);
  const double density = (1 - soil.porosity) * soil.grain_density;
  return {std::sqrt(density * law.constrained_modulus()), std::sqrt(density * law.shear_modulus())};
}

template <int dim>
Vector<dim> solve(std::array<Vector<dim>, dim> rows, Vector<dim> right) {
  for (int k = 0; k < dim; ++k)  // symmetric and positive definite: no pivoting
    for (int r = 0; r < dim; ++r) {
      if (r == k) continue;
      const double factor = rows[r][k] / rows[k][k];
      for (int c = k; c < dim; ++c) rows[r][c] -= factor * rows[k][c];
      right[r] -= factor * right[k];
    }
  for (int k = 0; k < dim; ++k) right[k] /= rows[k][k];
  return right;
}

}  // namespace

template <int dim>
AbsorbingCondition<dim>::AbsorbingCondition(StagePlan<dim>& plan, SkeletonCycle<dim>& cycle,
                                            const std::vector<AbsorbingSide>& sides)
    : plan_(plan),
      cycle_(cycle),
      nodes_(plan),
      reaction_(plan.provide_on_nodes({"absorbing side's reaction", "R", dim == 2 ? "N/m" : "N", dim})),
      known_(plan.provide_on_run({"absorbing sides carry", "-", "-", 1})) {
  const bool held = plan.stage.motion == SkeletonMotion::quasi_static;
  for (const AbsorbingSide& side : sides) {
    boundary_side(plan, side.side, "an absorbing side", side.origin);  // there is soil behind it
    for (const auto& node : side_nodes(plan, side.side, "an absorbing side", side.origin, false)) {
      const Impedance z = impedance_of(plan.problem.soils[static_cast<std::size_t>(node.region)], side.origin);
      std::array<Vector<dim>, dim> resistance{};
      for (const auto& plane : node.planes)
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b)
            resistance[a][b] += plane.area * ((z.normal - z.tangential) * plane.normal[a] * plane.normal[b] +
                                              (a == b ? z.tangential : 0.0));
      index_.push_back(node.index);
      resistance_.push_back(resistance);
      if (held)
        for (std::size_t a = 0; a < dim; ++a) cycle.fixed[a].at(static_cast<std::size_t>(node.index)) = 1;
    }
  }
}

template <int dim>
void AbsorbingCondition<dim>::limit_acceleration() {
  const double dt = cycle_.dt;
  const bool held = plan_.stage.motion == SkeletonMotion::quasi_static;
  for (std::size_t k = 0; k < index_.size(); ++k) {
    const auto i = static_cast<std::size_t>(index_[k]);
    if (nodes_.empty(i)) continue;
    const double mass = nodes_.mass[0][i];
    if (!held && known_[0][0] == 0)
      for (int a = 0; a < dim; ++a) reaction_[a][i] = -mass * nodes_.acceleration[a][i];
    Vector<dim> right{};
    std::array<Vector<dim>, dim> rows{};
    for (int a = 0; a < dim; ++a) {
      right[a] = mass * nodes_.acceleration[a][i] + reaction_[a][i];
      for (int b = 0; b < dim; ++b) {
        right[a] -= resistance_[k][a][b] * nodes_.velocity[b][i];
        rows[a][b] = dt * resistance_[k][a][b] + (a == b ? mass : 0.0);
      }
    }
    const Vector<dim> acceleration = held ? Vector<dim>{} : solve<dim>(rows, right);
    for (int a = 0; a < dim; ++a)
      if (cycle_.fixed[static_cast<std::size_t>(a)][i] == 0 || held) nodes_.acceleration[a][i] = acceleration[a];
  }
  known_[0][0] = held ? 0 : 1;
}

template <int dim>
void AbsorbingCondition<dim>::limit_velocity() {
  if (plan_.stage.motion != SkeletonMotion::quasi_static) return;
  for (int node : index_)
    for (int a = 0; a < dim; ++a) nodes_.velocity[a][node] = 0;
}

template class AbsorbingCondition<2>;
template class AbsorbingCondition<3>;

}  // namespace wetfront::mpm
