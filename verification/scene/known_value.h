#pragma once

#include "verification/scene/scene.h"

#include <optional>
#include <string>

namespace wetfront::verification {

/// From where to where a number is known to lie, both included; the same twice for one number.
struct Band {
  double low = 0, high = 0;  ///< SI
};

/// SI unit of what an [[observed]] row names: "s", "m" or "m/s".
const char* unit_of_known(const std::string& quantity);

/// The number in what a source says: "6300 s", "about 6300 s", "4.3 to 5 m". Nothing where its words are other ones,
/// its unit is of another kind, the number is not above zero or the second is below the first.
std::optional<Band> number_in_words(const std::string& said, const std::string& unit);

/// What a scene's [[observed]] row of that quantity says of the experiment, or of the published simulation.
enum class Source { measured, simulated };
std::optional<Band> known_value(const Observation& known, Source source);
std::optional<Band> known_value(const Scene& scene, const std::string& quantity, Source source);

/// |value - known| / known, from the nearer end of what is known; 0 within.
double relative_distance(double value, const Band& known);

}  // namespace wetfront::verification
