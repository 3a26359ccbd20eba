#include "verification/suites/reference_suite.h"

#include "verification/suites/adaptive_case.h"
#include "verification/suites/reference/families.h"

namespace wetfront::verification {

std::vector<Case> reference_suite() {
  std::vector<Case> all;
  for (const auto family :
       {steady_cases, srivastava_yeh_cases, two_layer_cases, broadbridge_white_cases, sorptivity_cases,
        travelling_wave_cases, tracy_cases, celia_cases, kirkland_cases, dry_soil_cases, rain_cases, flume_slope_cases,
        manufactured_cases, order_in_time_cases, work_precision_cases, adaptive_cases})
    for (Case& test : family()) all.push_back(std::move(test));
  return all;
}

}  // namespace wetfront::verification
