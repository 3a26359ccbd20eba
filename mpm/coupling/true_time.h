#pragma once

#include "mpm/coupling/relative_inertia.h"
#include "mpm/coupling/skeleton_of_flow.h"
#include "mpm/coupling/undrained_answer.h"

#include <optional>

namespace wetfront::mpm {

/// Soil and its water moving as one body in true time (README.md section 8): in a step of the plan the skeleton takes
/// as many explicit cycles as its stability asks for, undrained; then water seeps for the whole step, implicitly,
/// through the pores where they are by then.
///
/// With the scheme semi-implicit the water has inertia against the grains too (RelativeInertia): the flow
/// is solved after every cycle then. Points carry "grain mass" beside "mass", which is that of grains and water here.
template <int dim>
class TrueTimeMotion : public SkeletonOfFlow<dim> {
 public:
  using SkeletonOfFlow<dim>::SkeletonOfFlow;

  void ready() override;
  void begin_stage() override;
  void begin_step() override;
  void end_step() override;
  bool in_true_time() const override { return true; }

 private:
  /// Of a cell, while its points move through it; of all its soils together (README.md section 1b).
  struct Cell {
    std::array<double, cell_nodes<dim>> share{};       ///< integral of N_i over the soils in it / their volume
    std::array<Vector<dim>, cell_nodes<dim>> slope{};  ///< mean of grad N_i over the cell [1/m]
  };
  class PoreForce;
  void join_own() override;
  void measure_cells() override;
  double volume_of(const Block& block) const;
  void add_pore_force();
  void move_undrained();
  void pay_reaction();
  void choose_cycles();
  void add_growth();
  void weigh_points();
  double stable_cycle() const;
  double longest_cycle() const;

  using SkeletonOfFlow<dim>::c_, SkeletonOfFlow<dim>::carried_, SkeletonOfFlow<dim>::contents_,
      SkeletonOfFlow<dim>::cycle_, SkeletonOfFlow<dim>::fresh_, SkeletonOfFlow<dim>::plan_, SkeletonOfFlow<dim>::value_,
      SkeletonOfFlow<dim>::volume_, SkeletonOfFlow<dim>::water_, SkeletonOfFlow<dim>::refresh_geometry,
      SkeletonOfFlow<dim>::press_points;
  Column *mass_ = nullptr, *grains_ = nullptr, *force_ = nullptr, *water_of_points_ = nullptr, *brought_ = nullptr;
  Column* cycles_per_step_ = nullptr;  ///< null: one
  const Column *position_ = nullptr, *velocity_ = nullptr;
  std::unique_ptr<RelativeInertia<dim>> relative_;  ///< null: water goes with the grains but for Darcy's flux
  std::vector<Cell> cells_;
  std::optional<UndrainedAnswer> answer_;
  std::vector<double> block_volume_;  ///< of the blocks, before they move [m^dim]
  std::vector<double> start_;
  long cycles_ = 0;
};

}  // namespace wetfront::mpm
