#pragma once

#include "verification/scene/scene.h"

#include <optional>
#include <string>

namespace wetfront::verification {

/// The scene's narrowest gate on a quantity, as written: relative, or in the quantity's unit (scene/quantities.h).
std::optional<double> narrowest_gate(const Scene& scene, const std::string& quantity);

/// The same in the unit of `value`, which relative gates are parts of; 0 where there is no gate.
double gate_on(const Scene& scene, const std::string& quantity, double value);

}  // namespace wetfront::verification
