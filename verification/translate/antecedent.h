#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/scene/scene.h"
#include "verification/translate/former_field.h"

#include <vector>

namespace wetfront::verification {

/// psi [m] at the nodes of `problem`'s mesh that antecedent rain leaves: the steady state under it, or the end of a
/// spin-up. `problem` is complete but for its initial state. Throws as the reference does.
std::vector<double> antecedent_head(const Scene& scene, fem_reference::RichardsProblem problem);

/// The same as pressures, on the reference's mesh; computed once per scene.
const FormerField& antecedent_pressure(const Scene& scene);

}  // namespace wetfront::verification
