#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// Components of the run column "rest watch".
enum RestEntry : int {
  rest_largest,  ///< kinetic energy of the points, so far [J]
  rest_loud,     ///< when it was last above the threshold [s]
  rest_reached,  ///< 1: RestCriterion is met
  rest_entries
};

/// Says when a dynamic stage has come to rest (RestCriterion). A body that has never moved faster than ten times
/// RestCriterion::slowest in the mean has not begun to move and is not looked at.
template <int dim>
class RestWatch : public Effect<dim> {
 public:
  explicit RestWatch(Origin origin)
      : Effect<dim>("rest watch", std::move(origin), "sum m v^2/2 against its largest (mpm/problem.h, RestCriterion)") {
  }
  void join(StagePlan<dim>& plan) override;
};

}  // namespace wetfront::mpm
