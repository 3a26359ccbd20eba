#pragma once

#include "mpm/seepage/nodal_water.h"

namespace wetfront::mpm {

/// Nodes of a side are those of its partner, moved by one vector: one pressure, one balance (ties.h).
template <int dim>
class Periodic : public Effect<dim> {
 public:
  Periodic(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("periodic sides", std::move(origin), "p(x + d) = p(x)"), water_(std::move(water)) {}
  /// Joins after all that hold nodes. Throws CannotPlan when a node has no partner.
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<NodalWater<dim>> water_;
};

}  // namespace wetfront::mpm
