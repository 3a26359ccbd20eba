#pragma once

#include "mpm/coupling/carried_water.h"
#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// How the pores move that water seeps through: from equilibrium to equilibrium (FixedStress), or in true time
/// (TrueTimeMotion). What `Seepage` asks of them, and what both do alike: stencils of moving points, the pore stress
/// they feel, the water they carry.
template <int dim>
class SkeletonOfFlow {
 public:
  explicit SkeletonOfFlow(std::shared_ptr<SkeletonCycle<dim>> cycle) : cycle_(std::move(cycle)) {}
  virtual ~SkeletonOfFlow() = default;
  /// `refresh(cells_changed)` makes what `Seepage` derives from points anew.
  void join(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns,
            const std::vector<SoilContent>& contents, std::function<void(bool)> refresh);
  /// What a region's pores hold at the trial pressure.
  virtual void add_storage(int region, const SoilContent& content) const;
  /// What is stored beside the pores.
  virtual void add_offsets() const {}

  virtual void ready() = 0;        ///< stencils and pores of the present places
  virtual void begin_stage() = 0;  ///< the water of the points
  virtual void begin_step() = 0;   ///< before the flow of a step
  virtual void end_step() = 0;     ///< after it
  const CarriedWater<dim>& carried() const { return *carried_; }
  /// Whether the step is the skeleton's, which the flow has to fill, or the flow's own.
  virtual bool in_true_time() const = 0;

 protected:
  /// Provides what is its own; makes `carried_`.
  virtual void join_own() = 0;
  /// Pores and what else is summed over the points of the cells; their stencils are filled.
  virtual void measure_cells() = 0;
  /// Stencils, cells and all that `Seepage` derives from the points' places.
  void refresh_geometry();
  /// g = chi p of nodal pressures at the points, and the suction where a law asks for it.
  void press_points(const Column& pressure);

  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  StagePlan<dim>* plan_ = nullptr;
  NodalWater<dim>* water_ = nullptr;
  SeepageColumns c_{};
  const std::vector<SoilContent>* contents_ = nullptr;
  std::unique_ptr<CarriedWater<dim>> carried_;
  Column *value_ = nullptr, *gradient_ = nullptr, *volume_ = nullptr, *pore_stress_ = nullptr, *suction_ = nullptr;
  bool fresh_ = true;  ///< no stage before has carried water

 private:
  std::function<void(bool)> refresh_;
  std::vector<std::size_t> occupied_;
};

}  // namespace wetfront::mpm
