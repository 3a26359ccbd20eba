#pragma once

#include "reports/record.h"

#include <string>

namespace wetfront::reports {

/// |error| / tolerance; NaN when there is no tolerance.
double tolerance_share(const Finding& finding);

/// A small SVG: the error as a bar on a scale whose mark is the tolerance, the reference bound as a whisker around the
/// bar's end, and the share in words. Bars beyond 1.5 tolerances end in an arrow.
std::string tolerance_bar(const Finding& finding);

}  // namespace wetfront::reports
