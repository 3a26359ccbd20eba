#pragma once

#include "reports/record.h"

namespace wetfront::reports {

/// Values per series that a page draws; a figure is 462 pixels wide.
inline constexpr std::size_t drawn_limit = 4000;

/// The series as drawn: itself up to `drawn_limit` values. Beyond, of each run of consecutive values the first, the
/// smallest and the largest x and y and those not finite (a gap stays a gap), so that the drawing keeps its
/// outline. Files keep every value.
Series thinned(const Series& series);

Figure thinned(const Figure& figure);

}  // namespace wetfront::reports
