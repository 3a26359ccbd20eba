#pragma once

#include "reports/record.h"

namespace wetfront::reports::testing {

/// A pressure field on a slope of 24 x 8 cells: MPM, reference, difference.
FieldPicture sample_picture();

/// A block of so many points that slides 2 m down a slope of 30 degrees and flattens, in so many frames; failure after
/// the third, rest in the last.
Film sample_film(int points, int frames);

/// Three rows of a matrix with marks: stable, refused, FAIL.
Table sample_matrix();

}  // namespace wetfront::reports::testing
