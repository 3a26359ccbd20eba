#pragma once

#include "mpm/coupling/anderson.h"
#include "mpm/coupling/relaxation.h"
#include "mpm/coupling/skeleton_of_flow.h"

namespace wetfront::mpm {

/// Seepage through a skeleton that deforms from equilibrium to equilibrium: the fixed-stress split (README.md section
/// 2).
///
///   W_i(p) = sum_r [P_i + B_i (g(p_i) - g(p_i^k))] S c(p_i) + Z_i + E_i,   g = chi p,
///
/// P_i pores of the present skeleton, B_i = sum_p N_i V_p / E_oed what they give way at constant total stress, Z_i the
/// stabilisation, E_i what Anderson's mixing of the passes adds. After every solve the skeleton is relaxed under the
/// new pressures; the split ends when the pores foreseen and found differ by less than Relaxation::coupling_tolerance,
/// expressed as pressure.
template <int dim>
class FixedStress : public SkeletonOfFlow<dim> {
 public:
  using SkeletonOfFlow<dim>::SkeletonOfFlow;

  void add_storage(int region, const SoilContent& content) const override;
  void add_offsets() const override;

  void ready() override;
  void begin_stage() override;  ///< and the skeleton comes to rest under the first pressures
  void begin_step() override;
  void end_step() override { carried_->take_increments(); }
  bool in_true_time() const override { return false; }

 private:
  /// Integrals over the points of one soil in a cell, kept while they move.
  struct Cell {
    double volume = 0, stiffness = 0;             ///< m3 (m2 per m); oedometer modulus [Pa]
    std::array<double, cell_nodes<dim>> share{};  ///< mean of N_i over the points of all soils in the cell, sum 1
    std::array<std::array<Vector<dim>, cell_nodes<dim>>, cell_nodes<dim>> strain{};  ///< sum_p N_i V_p grad N_j
    std::size_t cell = 0;
    int region = 0;
    const int* nodes = nullptr;
  };
  bool settle(int pass);
  void find_foreseen();
  void join_own() override;
  void measure_cells() override;
  Cell measure(const Block& block, std::array<Vector<dim>, cell_nodes<dim>>& slope) const;
  void rebase();
  void find_stabilisation();
  double pressure_scale() const;

  using SkeletonOfFlow<dim>::c_, SkeletonOfFlow<dim>::carried_, SkeletonOfFlow<dim>::contents_,
      SkeletonOfFlow<dim>::cycle_, SkeletonOfFlow<dim>::fresh_, SkeletonOfFlow<dim>::plan_, SkeletonOfFlow<dim>::water_,
      SkeletonOfFlow<dim>::refresh_geometry, SkeletonOfFlow<dim>::press_points;
  std::unique_ptr<Relaxer<dim>> relaxer_;
  Column *volume_before_, *pores_before_, *compliance_, *base_, *stabilisation_, *mixed_, *unsettled_, *displacement_;
  std::vector<Cell> cells_;
  std::vector<double> displaced_, history_, off_, stabilised_, weight_;
  Anderson anderson_;
  long passes_ = 0, left_ = 0;  ///< left: steps whose flow and skeleton were left as they were, near failure
  RelaxationCounts counts_;
};

}  // namespace wetfront::mpm
