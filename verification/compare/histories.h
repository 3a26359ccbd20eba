#pragma once

#include "meshes/field_history.h"

namespace wetfront::verification {

/// The three solutions of a comparison. `finer` is the reference on a finer mesh with a tighter tolerance: the
/// difference between the two references bounds the reference's own error.
struct Histories {
  meshes::FieldHistory candidate, reference, finer;
};

}  // namespace wetfront::verification
