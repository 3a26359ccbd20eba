#pragma once

#include "reports/write.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::reports {

/// The runs as JUnit XML, the form that continuous integration reads: a suite per run, a case per gated finding. FAIL
/// is a failure with error, tolerance and explanation; INCONCLUSIVE is skipped, with a message; a run without gates is
/// one case that is skipped, a FAIL without a finding that says so one that fails. Throws std::runtime_error when it
/// cannot be written.
void write_junit(const std::vector<RunGroup>& groups, const std::filesystem::path& file);

}  // namespace wetfront::reports
