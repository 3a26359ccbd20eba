#pragma once

#include "mpm/seepage/nodal_water.h"

namespace wetfront::mpm {

/// Rain, ponding and seepage faces of `seepage`, inside the Newton step: each boundary node takes
/// q = A min(I, -beta p), A its horizontal area, beta = 1e3 k/(mu h). The soil takes all the rain while its surface is
/// unsaturated; once p reaches 0 it takes what it can and the rest runs off. q < 0 is water seeping out.
template <int dim>
class RainOnSeepage : public Effect<dim> {
 public:
  RainOnSeepage(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("rainfall", std::move(origin),
                    "Martinelli 2020, capacity inside Newton's method; mpm/README.md section 5"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<NodalWater<dim>> water_;
};

/// Nodes of a side held at a pressure; the water this takes is the reaction of their balance.
template <int dim>
class HeldPressure : public Effect<dim> {
 public:
  HeldPressure(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("prescribed pressure", std::move(origin), "p = p_0 on a side"), water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<NodalWater<dim>> water_;
};

/// Unit gradient of total head: water leaves at K(p) along gravity, q.n = (k k_rel/mu) rho g.n.
template <int dim>
class FreeDrainage : public Effect<dim> {
 public:
  FreeDrainage(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("free drainage", std::move(origin), "grad p = 0: q = (k k_rel/mu) rho g"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<NodalWater<dim>> water_;
};

}  // namespace wetfront::mpm
