#pragma once

#include "mpm/plan/stage_plan.h"

#include <memory>

namespace wetfront::mpm {

/// The skeleton's elastic stiffness on the grid and its factors: turns out-of-balance forces into displacements,
///
///   K_ij^ab = sum_p V_p [G (delta_ab grad N_i . grad N_j + d_b N_i d_a N_j) - (2G/3) d_a N_i d_b N_j]
///             + K sum_c V_c <d_a N_i> <d_b N_j>,
///
/// <> the mean over the cell's points (LockingRemedy::b_bar; the points' own gradients without it). It knows nothing of
/// yielding: near failure its displacements only lead towards equilibrium, and damped motion has to find it.
template <int dim>
class ElasticSolve {
 public:
  /// `fixed`: nodes without displacement, per axis.
  ElasticSolve(const StagePlan<dim>& plan, const std::array<std::vector<int>, 3>& fixed);
  ~ElasticSolve();

  /// The direct factors of a plane problem stay small; beyond this they cost more than damped motion does.
  static constexpr std::size_t most_unknowns = dim == 2 ? 100000 : 15000;

  /// Stiffness of the points where they are now. False when it cannot be factorised.
  bool factorise();
  bool ready() const;
  /// displacement = K^-1 force; both over nodes, `dim` components.
  void solve(const Column& force, Column& displacement) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace wetfront::mpm
