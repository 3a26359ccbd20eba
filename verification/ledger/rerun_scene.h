#pragma once

#include "mpm/problem.h"
#include "verification/ledger/difference_ledger.h"

#include <functional>

namespace wetfront::verification {

/// Runs the scene's own MPM again as a probe asks. `change` is applied to every problem before it is solved: faults
/// that tests inject. Both references must outlive the runner. Absent for a mesh of the user's own, whose cells cannot
/// be halved by the scene.
CandidateRunner rerun_scene(const Scene& scene, const Timeline& timeline,
                            std::function<void(mpm::Problem<2>&)> change = {});

}  // namespace wetfront::verification
