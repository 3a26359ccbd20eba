#pragma once

#include "mpm/simulation.h"

#include <filesystem>
#include <optional>
#include <string>

namespace wetfront::verification {

/// Where a run keeps its state: `file`, and beside it (".before") the one before that.
struct CheckpointFile {
  std::filesystem::path file;
  std::string belongs_to;  ///< scene and program, by hash: a state of another is not taken
};

/// Moves the last checkpoint aside and writes a new one, whole or not at all. Throws std::runtime_error.
void write_checkpoint(const mpm::State& state, const CheckpointFile& where);

/// The newest whole checkpoint of this scene and program; absent where there is none. `note` says what was wrong with
/// those passed over.
std::optional<mpm::State> read_checkpoint(const CheckpointFile& where, std::string& note);

/// Removes both, of a run that has reached its end.
void forget_checkpoint(const CheckpointFile& where);

/// What identifies scene and program in checkpoints.
std::string checkpoint_owner(const std::string& scene_text);

}  // namespace wetfront::verification
