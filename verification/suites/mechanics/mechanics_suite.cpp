#include "verification/suites/mechanics/mechanics_suite.h"

#include "verification/suites/mechanics/families.h"

namespace wetfront::verification {

std::vector<Case> mechanics_suite() {
  std::vector<Case> all;
  for (const auto family : {bar_cases, gravity_column_cases, manufactured_motion_cases, rotation_cases,
                            motion_work_cases, material_path_cases, footing_cases, incline_cases, wide_block_cases,
                            collapse_cases, wet_column_cases, wet_block_cases, wet_collapse_cases})
    for (Case& test : family()) all.push_back(std::move(test));
  return all;
}

}  // namespace wetfront::verification
