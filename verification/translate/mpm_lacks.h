#pragma once

#include "verification/scene/scene.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// What of the scene the material point method of this version cannot do, each `file:line:column: ... Use 'wetfront
/// reference' ...`; empty when it can do all of it.
std::vector<std::string> mpm_lacks(const Scene& scene);

}  // namespace wetfront::verification
