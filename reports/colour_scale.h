#pragma once

#include <string>

namespace wetfront::reports {

/// "#rrggbb" for a share from 0 to 1, clamped: from dark blue to yellow, as bright as large (viridis; Smith & van der
/// Walt 2015), which also reads in grey and with any colour vision.
std::string sequential_colour(double share);

/// From blue over near white at one half to red (ColorBrewer's RdBu; Brewer 2003): for differences.
std::string diverging_colour(double share);

}  // namespace wetfront::reports
