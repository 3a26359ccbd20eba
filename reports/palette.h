#pragma once

#include "reports/record.h"

#include <string>
#include <vector>

/// Colours and marks of series. The colours are those of Okabe and Ito (2008, "Color universal design"), told apart
/// under the common colour-vision deficiencies; the marks differ as well, so that no reading rests on colour alone.
namespace wetfront::reports {

/// "#rrggbb" of a palette index (taken modulo the palette's size).
std::string colour_of(int index);

/// gnuplot point type of a palette index (open circle, square, triangle, ...).
int mark_of(int index);

/// Palette index of each series: its own, or for -1 the lowest that no series of the figure names.
std::vector<int> palette_indices(const Figure& figure);

}  // namespace wetfront::reports
