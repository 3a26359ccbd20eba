#pragma once

#include "mpm/boundary/skeleton_nodes.h"
#include "mpm/boundary/surface.h"

namespace wetfront::mpm {

/// f_i += (t - p n) A_i times the factor, on a side of the mesh or on the free surface where it is now. Stops the run
/// (StepFailed) when soil has left a loaded side.
template <int dim>
class TractionCondition : public NodalCondition<dim> {
 public:
  TractionCondition(StagePlan<dim>& plan, const Traction& spec);
  void add_force() override;

 private:
  void add_on_side(double factor);
  void add_on_surface(double factor);

  StagePlan<dim>& plan_;
  SkeletonNodes<dim> nodes_;
  Traction spec_;
  std::vector<int> index_;
  std::vector<Vector<dim>> load_;          ///< force on each of these nodes at factor 1 [N]
  std::unique_ptr<Surface<dim>> surface_;  ///< where the load is on the free surface
};

}  // namespace wetfront::mpm
