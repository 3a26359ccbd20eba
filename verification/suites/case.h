#pragma once

#include "reports/record.h"

#include <functional>
#include <string>

namespace wetfront::verification {

class CaseBook;

/// What a case takes in CPU seconds on the usual machine: quick < 1, everyday < 6, heavy: what takes more.
enum class Effort { quick, everyday, heavy };

/// One page of a suite: problems that are solved, measurements held against what is expected, figures. To add one,
/// write `run` in a file of its own and list it in reference_suite.cpp.
struct Case {
  std::string name;         ///< folder and key: lower case, digits, underscores
  std::string title;        ///< opens with its gate, if it has one: "R4 Broadbridge-White, ..."
  std::string requirement;  ///< one sentence
  std::string source;       ///< paper and equations, or whose tables
  Effort effort = Effort::quick;
  std::function<void(CaseBook&)> run;
};

/// Runs the case and judges it. A solver that gives up, or any other exception, is a failed finding on the page.
reports::Record run_case(const Case& test);

}  // namespace wetfront::verification
