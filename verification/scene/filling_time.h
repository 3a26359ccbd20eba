#pragma once

#include "verification/scene/scene.h"

#include <optional>
#include <string>

namespace wetfront::verification {

/// Filling time of a column: storage deficit over rain,
///   t_fill = integral over the height of n (S_max - S(p_initial)) dz / I.
/// The compressibility of the water is left out: with K_l = 0.2 GPa it adds 0.05 % to the seed column with
/// S_min = 0.87, and 0.007 % with 0.087.
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
