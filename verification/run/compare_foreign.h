#pragma once

#include "verification/foreign/foreign_result.h"
#include "verification/run/run_scene.h"

namespace wetfront::verification {

/// Judges another code's result by the scene's gates against the scene's reference, as far as its data allow, and says
/// where the differences come from; report and result into `folder`.
RunResult compare_foreign(const Scene& scene, const ForeignResult& foreign, const std::filesystem::path& folder,
                          const ReferenceStore& store);

}  // namespace wetfront::verification
