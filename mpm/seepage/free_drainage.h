#pragma once

#include "mpm/seepage/nodal_water.h"

namespace wetfront::mpm {

/// Unit gradient of total head: water leaves at K(p) along gravity, q.n = (k k_rel/mu) rho g.n.
template <int dim>
class FreeDrainage : public Effect<dim> {
 public:
  FreeDrainage(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("free drainage", std::move(origin), "grad p = 0: q = (k k_rel/mu) rho g"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  void drain(StagePlan<dim>& plan, int condition);

  std::shared_ptr<NodalWater<dim>> water_;
};

}  // namespace wetfront::mpm
