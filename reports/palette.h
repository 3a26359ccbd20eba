#pragma once

#include "reports/record.h"

#include <string>
#include <vector>

/// Colours and marks of series. The colours are those of Okabe and Ito (2008, "Color universal design"), told apart
/// under the common colour-vision deficiencies; the marks differ as well, so that no reading rests on colour alone.
namespace wetfront::reports {

/// "#rrggbb" of a palette index (taken modulo the palette's size), or of one of the two below.
std::string colour_of(int index);

/// Indices of what is to be told apart from any number of other curves: black, brown.
inline constexpr int colour_of_the_reference = 1000, colour_of_the_best = 1001;

/// gnuplot point type of a palette index (open circle, square, triangle, ...).
int mark_of(int index);

/// Palette index of each series: its own, or for -1 the lowest that no series of the figure names.
std::vector<int> palette_indices(const Figure& figure);

}  // namespace wetfront::reports
