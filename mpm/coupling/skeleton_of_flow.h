#pragma once

#include "mpm/coupling/carried_water.h"

namespace wetfront::mpm {

/// How the pores move that water seeps through: from equilibrium to equilibrium (FixedStress), or in true time
/// (TrueTimeMotion). What `Seepage` asks of them.
template <int dim>
class SkeletonOfFlow {
 public:
  virtual ~SkeletonOfFlow() = default;
  /// `refresh(cells_changed)` makes what `Seepage` derives from points anew.
  virtual void join(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns,
                    const std::vector<SoilContent>& contents, std::function<void(bool)> refresh) = 0;
  virtual void add_storage(int region, const SoilContent& content) const = 0;
  /// What is stored beside the pores.
  virtual void add_offsets() const {}

  virtual void ready() = 0;        ///< stencils and pores of the present places
  virtual void begin_stage() = 0;  ///< the water of the points
  virtual void begin_step() = 0;   ///< before the flow of a step
  virtual void end_step() = 0;     ///< after it
  virtual const CarriedWater<dim>& carried() const = 0;
  /// Whether the step is the skeleton's, which the flow has to fill, or the flow's own.
  virtual bool in_true_time() const = 0;
};

}  // namespace wetfront::mpm
