#pragma once

#include "verification/suites/case.h"
#include "verification/suites/run_suite.h"

#include <vector>

namespace wetfront::verification {

/// The rows of the hard-case matrix as cases.
std::vector<Case> hard_suite();

/// Runs them and writes, besides their pages, the matrix: rows are cases, columns schemes. True where no entry fails.
bool run_hard_suite(const SuiteOptions& options);

}  // namespace wetfront::verification
