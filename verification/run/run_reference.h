#pragma once

#include "verification/run/run_scene.h"

namespace wetfront::verification {

struct ReferenceResult {
  reports::Record record;
  Exit exit = Exit::pass;
  ReferenceRuns runs;
};

/// The reference of a scene alone, with its own error, into `folder`. What the material point method could not do with
/// the scene does not matter here.
ReferenceResult run_reference(const Scene& scene, const std::filesystem::path& folder, const ReferenceStore& store);

}  // namespace wetfront::verification
