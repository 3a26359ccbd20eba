#include "verification/suites/hard/give_skeleton.h"

#include "verification/suites/hard/free_energy.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {

void give_skeleton(mpm::Problem<2>& problem) {
  double young = 100e6;
  for (const mpm::Soil& soil : problem.soils)
    for (const double p : problem.initial_pressure)
      if (std::isfinite(p)) young = std::max(young, 1e3 * std::abs(p) * saturation(soil, p));
  for (mpm::Soil& soil : problem.soils) soil.elastic = mpm::Elastic{young, 0.3, "row: skeleton"};
  problem.initial_stress = mpm::InitialStress::k0;
  problem.fixities = {{"base", {true, true, false}, "row: skeleton"},
                      {"left", {true, false, false}, "row: skeleton"},
                      {"right", {true, false, false}, "row: skeleton"}};
}

}  // namespace wetfront::verification
