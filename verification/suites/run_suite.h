#pragma once

#include "verification/suites/case.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::verification {

struct SuiteOptions {
  std::filesystem::path out;
  bool heavy = false;  ///< also what takes more than some seconds
  std::string only;    ///< cases whose name contains this; empty: all
  int processes = 2;   ///< cases side by side, each in a process of its own; each case runs on one core
};

/// Runs the cases, writes a page for each into out/<name> and an index, prints a line per case as it ends. True where
/// no case failed. Throws std::invalid_argument where no case is chosen.
bool run_suite(const std::vector<Case>& suite, const SuiteOptions& options, const std::string& title);

}  // namespace wetfront::verification
