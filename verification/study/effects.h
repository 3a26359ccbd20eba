#pragma once

#include "reports/record.h"
#include "verification/scene/scene.h"
#include "verification/study/point_result.h"

#include <filesystem>
#include <string>
#include <vector>

/// Which effects a scene needs: each that it calls for is left out in turn, each that it does not call for is added.
namespace wetfront::verification {

struct EffectChange {
  std::string effect;      ///< "inertia of the water"
  bool called_for = true;  ///< by the scene: left out; else added
  std::string how;         ///< what was changed
  StudyPoint point;
  double cells = 1;         ///< per direction, over the scene's
  std::size_t base = 0;     ///< number of the run without the change on the same cells
  std::string by_nature{};  ///< why the scene needs it whatever a run says; mostly empty
};

/// The first point is the scene itself, the second the same on cells half as large, which tells what the numbers are
/// worth; then one per effect. Names and settings only: nothing is meshed. Throws SceneError for a mesh of the user's
/// own.
std::vector<EffectChange> effect_changes(const Scene& scene);

/// An effect that no setting takes away or adds, and why.
struct InseparableEffect {
  std::string effect;
  bool called_for;
  std::string why;
};
/// Effects that a reader would look for among those tried.
std::vector<InseparableEffect> inseparable_effects(const Scene& scene);

/// The same, but an effect that is expected to cost more than `budget` CPU seconds is tried on cells twice or four
/// times as large where that is within it, against the scene on such cells, which is added at the end.
std::vector<EffectChange> affordable(const Scene& scene, std::vector<EffectChange> changes, double budget);

/// Influence of an effect on one outcome and what follows.
enum class Need { needed, not_needed, undecided, unknown };
struct Influence {
  std::string outcome, unit;
  double value = 0;        ///< of the scene as it is
  double change = 0;       ///< of the outcome, in its unit
  double uncertainty = 0;  ///< of the change: what the mesh leaves open
  double tolerance = 0;    ///< below which nobody would notice: the scene's gate, or 1 % of the outcome
  bool gated = false;      ///< the tolerance is a gate of the scene
  Need need = Need::unknown;
  bool vanishes = false;  ///< an event that happens in the scene as it is only
  bool appears = false;   ///< one that happens in the changed run only
};
/// Needed where |change| - uncertainty > tolerance, not needed where |change| + uncertainty <= tolerance. `changed` and
/// `base` are on the same cells, `finer` is on finer ones. An event that happens in one of the two only: needed, but
/// undecided on cells other than the scene's (`cells` over the scene's), which may miss it. Empty where one of them was
/// refused or gave up.
std::vector<Influence> influences(const Scene& scene, const PointResult& base, const PointResult& finer,
                                  const PointResult& changed, double cells = 1);
/// Needed where it is for any outcome; not needed where it is not for all.
Need overall_need(const std::vector<Influence>& influences);

/// What the scene needs, in plain words.
std::string effect_sentence(const EffectChange& change, const PointResult& result,
                            const std::vector<Influence>& influences);

reports::Record effects_page(const Scene& scene, const std::vector<EffectChange>& changes,
                             const std::vector<PointResult>& results, const std::filesystem::path& out);

/// The sentences of a stored study of this scene, for `explain`; empty where there is none.
std::vector<std::string> stored_effects(const Scene& scene, const std::filesystem::path& folder);

}  // namespace wetfront::verification
