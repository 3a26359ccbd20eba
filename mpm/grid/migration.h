#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// Sorts points into the cells they have moved to; nothing to do, and nothing done, while all stay. The only place
/// where points change cells (and later, owners).
template <int dim>
class Migration {
 public:
  /// Provides the step columns "cell", "slot" and "scratch".
  explicit Migration(StagePlan<dim>& plan);
  /// Throws StepFailed when a point has left the mesh or entered cells of another soil.
  void run();

 private:
  bool find_cells();
  void find_slots();
  void permute(Column& column);

  StagePlan<dim>& plan_;
  Column &cell_, &slot_, &scratch_;
  std::vector<std::size_t> counts_, next_;
};

}  // namespace wetfront::mpm
