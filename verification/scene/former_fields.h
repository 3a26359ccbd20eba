#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The fields that a run has left, from the collection it writes (`fields/reference_grid.pvd`); empty when there is
/// none.
struct FormerFields {
  std::vector<double> time;       ///< s
  std::vector<std::string> file;  ///< beside the collection
};
FormerFields former_fields(const std::filesystem::path& collection);

}  // namespace wetfront::verification
