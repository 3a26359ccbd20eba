#pragma once

#include "meshes/field_history.h"

#include <filesystem>
#include <optional>

namespace wetfront::verification {

/// Writes a solver's whole result to `path` (CBOR with a check sum), in one move: a reader never sees half a file.
/// Throws std::runtime_error when it cannot.
void write_history(const meshes::FieldHistory& history, const std::filesystem::path& path);

/// Reads it back, to the bit; absent where there is no such file, or not a whole one of this version.
std::optional<meshes::FieldHistory> read_history(const std::filesystem::path& path);

}  // namespace wetfront::verification
