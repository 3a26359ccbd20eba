#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"
#include "verification/translate/timeline.h"

#include <vector>

namespace wetfront::verification {

/// Energy and momentum of a skeleton that moves dynamically, for a history with `motion`: at those comparison times at
/// which it moves and at the end; in a slide, which has none of them, at times spread over it.
reports::Table motion_table(const meshes::FieldHistory& history, const Timeline& timeline);

/// Kinetic energy, the works, momentum and the impulses that explain it, and the water, over the time since the
/// skeleton began to move (`after_failure`: since failure); empty where none moves dynamically.
std::vector<reports::Figure> motion_figures(const meshes::FieldHistory& history, bool after_failure = false);

}  // namespace wetfront::verification
