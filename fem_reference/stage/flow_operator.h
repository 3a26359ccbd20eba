#pragma once

#include "fem_reference/cpu_clock.h"
#include "fem_reference/linear/linear_solver.h"
#include "fem_reference/soil/soil_law.h"
#include "fem_reference/space/discretisation.h"
#include "fem_reference/stage/boundary.h"

#include <span>
#include <vector>

namespace wetfront::fem_reference {

/// The discrete Richards operator (README, Eq 3):
///   m_i dW_i/dt = R_i(psi),  R_i = - sum_q w_q K(psi_h) grad N_i . T (grad psi_h - g) - drainage_i + m_i f(x_i, t),
/// with g the unit vector of gravity, psi_h at the Gauss points, m and the boundary lumped. All in m^dim/s.
class FlowOperator {
 public:
  FlowOperator(const RichardsProblem& problem, const Discretisation& space, const Boundary& boundary);

  /// Evaluates R, W and their derivatives' ingredients at psi [dof]; the results stay until the next call.
  void evaluate(std::span<const double> head);
  /// Takes the water that comes up inside the soil at `time` [s]; evaluate() then counts it in R.
  void set_time(double time);
  bool has_source() const { return static_cast<bool>(source_function_); }
  /// Water that comes up inside the soil at the time last set [m^dim/s].
  double source_total() const;
  const std::vector<double>& inflow() const { return inflow_; }  ///< R_i [m^dim/s]
  /// Sum of the sizes of what R_i is the sum of [m^dim/s]: its rounding error is some epsilon of that.
  const std::vector<double>& passing() const { return passing_; }
  const std::vector<double>& water() const { return water_; }        ///< W_i [-], soils averaged by volume
  const std::vector<double>& capacity() const { return capacity_; }  ///< dW_i/dpsi [1/m]
  const std::vector<double>& volume() const { return volume_; }      ///< m_i [m^dim]
  const std::vector<double>& drained() const { return drained_; }    ///< outflow per condition [m^dim/s]

  /// m_i dW_i/dpsi delta_ij - tau dR_i/dpsi_j at the psi of the last evaluate().
  void assemble(double tau, SparseMatrix& matrix) const;
  SparseMatrix pattern() const;

  /// W of one degree of freedom at a head, and its slope, without touching what evaluate() left.
  ValueAndSlope storage_at(int dof, double head) const;
  /// W alone, without touching what evaluate() left.
  std::vector<double> water_at(std::span<const double> head) const;
  /// Water in the soil for given W [m^dim].
  double stored(std::span<const double> water) const;

  /// psi of the last evaluate() [dof, then ghost].
  const std::vector<double>& head() const { return head_; }

  const Discretisation& space() const { return space_; }
  const Boundary& boundary() const { return boundary_; }
  const std::vector<SoilLaw>& laws() const { return laws_; }
  Cost evaluation_cost;
  mutable Cost assembly_cost;

 private:
  void evaluate_storage(std::span<const double> head);
  void evaluate_flow(std::span<const double> head);
  void evaluate_conductivity(int cell, std::span<const double> head);
  void blend_conductivity(int cell, std::span<const double> head, double factor, int most, int least);
  void evaluate_drainage(std::span<const double> head);
  void sort_shares();
  void make_pattern();
  void turn(int soil, double* vector) const;

  const Discretisation& space_;
  const Boundary& boundary_;
  std::vector<SoilLaw> laws_;
  std::array<double, 3> gravity_;
  std::vector<char> isotropic_;                    ///< per soil
  std::vector<std::array<double, 6>> anisotropy_;  ///< T per soil
  std::vector<double> volume_, water_, capacity_, inflow_, passing_, drained_, drainage_slope_;
  std::function<double(const meshes::Point&, double)> source_function_;
  std::vector<double> source_;              ///< m_i f(x_i, t); empty without a source
  std::vector<double> factor_;              ///< per mesh cell, times Ks; empty: 1
  std::vector<double> head_;                ///< [dof, then ghost]
  std::vector<double> drive_;               ///< T (grad psi - g), [cell][point][axis]
  std::vector<double> conductivity_;        ///< [cell][point]
  std::vector<double> conductivity_slope_;  ///< dK/dpsi_b, [cell][point][local dof]
  std::vector<double> scratch_;
  std::vector<std::pair<int, double>> shares_;  ///< soil and part of the volume, by dof
  std::vector<int> first_share_;                ///< [dof] -> shares_
  SparseMatrix pattern_;
  std::vector<int> diagonal_;  ///< [dof] -> entry
  std::vector<int> entry_;     ///< [cell][local row][local column] -> entry
};

}  // namespace wetfront::fem_reference
