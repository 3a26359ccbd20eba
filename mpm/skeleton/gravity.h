#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// Offers the acceleration g [m/s2] as the run column "gravity"; whoever has weight requires or finds it.
template <int dim>
class Gravity : public Effect<dim> {
 public:
  explicit Gravity(Origin origin) : Effect<dim>("gravity", std::move(origin), "b = g in Lee 2021 Eqs 1 and 2") {}
  void join(StagePlan<dim>& plan) override {
    Column& gravity = plan.provide_on_run({"gravity", "g", "m/s2", dim});
    plan.at_entry([&gravity, g = plan.problem.gravity] {
      for (int a = 0; a < dim; ++a) gravity[a][0] = g[static_cast<std::size_t>(a)];
    });
  }
};

}  // namespace wetfront::mpm
