#pragma once

#include "mpm/boundary/skeleton_nodes.h"
#include "mpm/boundary/surface.h"

namespace wetfront::mpm {

/// f_i += (t - p n) A_i times the factor, on a side of the mesh or on the free surface where it is now. Stops the run
/// (StepFailed) when soil has left a loaded side.
template <int dim>
class TractionCondition : public NodalCondition<dim> {
 public:
  /// `number`: among the tractions of the problem, 0, 1, ...
  TractionCondition(StagePlan<dim>& plan, const Traction& spec, int number);
  void add_force() override;

 private:
  void load_side();
  void add_on_side(double factor);
  void add_on_surface(double factor);

  StagePlan<dim>& plan_;
  SkeletonNodes<dim> nodes_;
  Traction spec_;
  /// Force on the nodes of the side at factor 1, of its faces with soil behind them when the stage began: a run that
  /// goes on later must not load others.
  Column* load_ = nullptr;
  std::vector<int> index_;                 ///< of the loaded nodes
  std::unique_ptr<Surface<dim>> surface_;  ///< where the load is on the free surface
};

}  // namespace wetfront::mpm
