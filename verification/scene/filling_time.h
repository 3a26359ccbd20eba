#pragma once

#include "verification/scene/scene.h"

#include <optional>
#include <string>

namespace wetfront::verification {

/// Filling time of a column: storage deficit over rain,
///   t_fill = integral over the height of n (S_max - S(p_initial)) dz / I.
/// Either `seconds` is set, or `why_not` says why the scene has no filling time ("water passes through 'base'");
/// in a scene that has other mistakes both may be empty.
struct FillingTime {
  std::optional<double> seconds;
  std::string why_not;
};
FillingTime filling_time(const Scene& scene);

/// Seconds of a scene time; none when it is relative and the scene has no filling time.
std::optional<double> seconds_of(const SceneTime& time, const FillingTime& filling);

}  // namespace wetfront::verification
