#pragma once

#include "mpm/plan.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// What `wetfront explain` prints of the MPM: per stage the effects and the scene line that called for each, the
/// columns with their bytes per slot, per point and in all [MB of 1e6 bytes], the kernels in order, the step limits
/// with the binding one, and the cost.
std::string plan_text(const std::vector<mpm::PlanInfo>& plans);

}  // namespace wetfront::verification
