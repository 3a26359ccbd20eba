#pragma once

#include <filesystem>
#include <vector>

namespace wetfront::reports {

/// Runs the scripts in `folder` with one gnuplot. Throws std::runtime_error when gnuplot is missing (saying which
/// package has it) or fails (with what it printed).
void run_gnuplot(const std::vector<std::filesystem::path>& scripts, const std::filesystem::path& folder);

}  // namespace wetfront::reports
