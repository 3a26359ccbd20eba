#pragma once

#include "meshes/field_history.h"

#include <optional>

namespace wetfront::verification {

/// The solutions of a comparison: the candidate, the reference, and the reference's relatives that show its own error.
struct Histories {
  meshes::FieldHistory candidate;
  meshes::FieldHistory reference;                 ///< as the scene asks for it
  std::optional<meshes::FieldHistory> coarser{};  ///< cells twice as large; absent where the mesh cannot be coarsened
  meshes::FieldHistory finer{};                   ///< cells half as large
  meshes::FieldHistory tighter{};                 ///< the reference's mesh, a tenth of its tolerance
};

}  // namespace wetfront::verification
