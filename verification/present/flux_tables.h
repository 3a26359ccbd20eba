#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <vector>

namespace wetfront::verification {

/// The ledger of the reference and, where the candidate keeps one, the water through each side of both, until the end
/// of the window that is compared; where that ends with failure [s; infinity: it does not], titles and captions say so.
std::vector<reports::Table> compared_fluxes(const Scene& scene, const Timeline& window, double failure,
                                            const meshes::FieldHistory& candidate,
                                            const meshes::FieldHistory& reference);

/// The candidate's ledger to its own end, with a row at failure to hold against the reference's last.
reports::Table ledger_of_run(const Scene& scene, const Timeline& timeline, double failure,
                             const meshes::FieldHistory& candidate);

}  // namespace wetfront::verification
