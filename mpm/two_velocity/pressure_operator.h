#pragma once

#include "mpm/two_velocity/water.h"

#include <vector>

namespace wetfront::mpm {

/// The geometry of one linearised step of the liquid in a resting skeleton, as an operator on cell pressures:
///   A_cc' = 1/V_c sum_ij faces_ci . [P M P]_ij gradient_c'j / V_j   [1/m2],
/// pressure to nodal force, walls (P), points and back (M_ij = sum_p V_p N_i N_j / V_i), outflow. An oscillation of
/// pressure has w^2 = A nS/(C rho_l). In an unbounded uniform column A is the second difference between cells,
/// 4/h^2 at most, times what mapping leaves of the mode, 1.5/h^2 at most with four points per cell.
template <int dim>
class PressureOperator {
 public:
  PressureOperator(const StagePlan<dim>& plan, const TwoVelocityWater<dim>& water);

  /// What mapping does to a mode m in [0, 1] of M: M itself without drag, M/(2 - M) where drag rules
  /// (README.md section 6).
  enum class Drag { none, ruling };
  /// What the bound of a cell is in proportion to: its diagonal entry, with mapping (the sharper one among full cells)
  /// or without (the sharper one where a sliver decides).
  enum class Scale { mapped, unmapped };
  void scale_by(Scale scale);
  /// A number k_c per cell with A <= diag(k) [1/m2]: the scale chosen before, times the largest eigenvalue
  /// that the whole mesh leaves (power iteration). A bound for any C and nS that vary from cell to cell.
  std::vector<double> bound(Drag drag);

 private:
  void apply(Drag drag);
  void map();
  void project();

  const StagePlan<dim>& plan_;
  const TwoVelocityWater<dim>& water_;
  std::vector<std::array<std::array<double, cell_nodes<dim>>, cell_nodes<dim>>> mass_;  ///< sum_p V_p N_i N_j, by block
  std::vector<double> pressure_, outflow_, diagonal_;                                   ///< by block
  std::vector<Vector<dim>> node_, mapped_, sum_;
};

}  // namespace wetfront::mpm
