#pragma once

#include "mpm/laws/log_table.h"
#include "mpm/problem.h"

/// Every law of problem.h as a function to be sampled into a table.
namespace wetfront::mpm {

/// Effective saturation Se(s) of a retention curve, and the saturations it runs between.
struct SampledRetention {
  SampledLaw effective;
  double s_min = 0, s_max = 1;
  double pressure_scale = 0;  ///< Pa: where the curve bends
};
SampledRetention sampled_retention(const RetentionSpec& spec);

/// k_rel(s) of a soil. Throws CannotPlan where the soil's two laws do not go together.
SampledLaw sampled_permeability(const Soil& soil);

}  // namespace wetfront::mpm
