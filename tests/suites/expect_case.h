#pragma once

#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/hydraulics_suite.h"
#include "verification/suites/reference_suite.h"

#include <gtest/gtest.h>

namespace wetfront::verification::testing {

class SuiteCase : public ::testing::TestWithParam<Case> {};

/// Runs the case; every finding that is not passed (or shown only) is named.
inline void expect_pass(const Case& test) {
  const reports::Record record = run_case(test);
  EXPECT_FALSE(record.findings.empty());
  for (const auto& finding : record.findings)
    EXPECT_TRUE(finding.verdict == reports::Verdict::pass || finding.verdict == reports::Verdict::info)
        << finding.description << ": " << finding.error << ", tolerance " << finding.tolerance << ". "
        << finding.explanation;
}

inline std::vector<Case> cases_up_to(Effort most, std::vector<Case> suite) {
  std::vector<Case> cases;
  for (Case& test : suite)
    if (test.effort <= most) cases.push_back(std::move(test));
  return cases;
}

inline std::string case_name(const ::testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

}  // namespace wetfront::verification::testing
