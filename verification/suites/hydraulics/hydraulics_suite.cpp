#include "verification/suites/hydraulics/hydraulics_suite.h"

#include "verification/suites/hydraulics/families.h"

namespace wetfront::verification {

std::vector<Case> hydraulics_suite() {
  std::vector<Case> all;
  for (const auto family :
       {column_cases, closed_form_water_cases, broadbridge_white_water_cases, celia_water_cases, layer_cases,
        plane_cases, surface_cases, slope_cases, scheme_cases, time_step_cases, work_precision_water_cases})
    for (Case& test : family()) all.push_back(std::move(test));
  return all;
}

}  // namespace wetfront::verification
