#pragma once

#include "meshes/field_history.h"
#include "mpm/body_record.h"
#include "verification/compare/histories.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// A solver's result and, if it gave up, why.
struct Solved {
  meshes::FieldHistory history;
  std::string gave_up;     ///< empty: it reached the end
  std::string taken_from;  ///< file of the store it was taken from; empty: computed now
  mpm::BodyRecord body{};  ///< of the candidate
  bool stopped = false;    ///< it gave up because it was asked to
};

/// Where solutions of the reference are kept, each under the hash of its problem and of the code: computed once.
struct ReferenceStore {
  std::filesystem::path folder;  ///< empty: nothing is kept or taken
};

/// The reference as the scene asks for it, and the three runs that show its own error (compare/reference_error.h).
struct ReferenceRuns {
  Solved reference, finer, tighter;
  std::optional<Solved> coarser;

  /// Each with its name, e.g. {"reference", &reference}.
  std::vector<std::pair<std::string, const Solved*>> all() const;
};
ReferenceRuns solve_references(const Scene& scene, const Timeline& timeline, const ReferenceStore& store);

/// The reference alone, without what shows its error.
Solved solve_reference(const Scene& scene, const Timeline& timeline, const ReferenceStore& store);

Histories histories_of(meshes::FieldHistory candidate, const ReferenceRuns& reference);

}  // namespace wetfront::verification
