#pragma once

#include "mpm/seepage/nodal_water.h"

namespace wetfront::mpm {

/// Nodes of a side held at a pressure or a total head, constant, in time or as they start; the water this takes is the
/// reaction of their balance. Where sides meet, the last one in the problem wins. (Where the free surface cuts through
/// cells there are no nodes to hold: SurfaceExchange does it.)
template <int dim>
class HeldPressure : public Effect<dim> {
 public:
  HeldPressure(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("prescribed pressure", std::move(origin), "p = p_0(t), or rho |g| (H(t) - z), on a side"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  void hold(StagePlan<dim>& plan, int condition);
  void set_time(const StagePlan<dim>& plan, double end);

  std::shared_ptr<NodalWater<dim>> water_;
};

}  // namespace wetfront::mpm
