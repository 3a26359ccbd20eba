#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/suites/case_book.h"

namespace wetfront::verification {

/// Celia et al. 1990: 40 cm of Haverkamp's sand for 360 s, and 1 m of the New Mexico soil for 24 h, output at 6, 12, 24
/// h.
fem_reference::RichardsProblem celia_sand(int cells);
fem_reference::RichardsProblem celia_new_mexico(int cells);

/// Judges heads and front places of a run on a line against the printed tables, and draws the profiles.
void judge_celia_sand(CaseBook& book, const meshes::FieldHistory& history);
void judge_celia_new_mexico(CaseBook& book, const meshes::FieldHistory& history);

}  // namespace wetfront::verification
