// Every case of the suites that takes less than a second.
#include "tests/suites/expect_case.h"

namespace wetfront::verification {
namespace {

using namespace testing;

TEST_P(SuiteCase, Passes) {
  expect_pass(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Reference, SuiteCase, ::testing::ValuesIn(cases_up_to(Effort::quick, reference_suite())),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Hydraulics, SuiteCase, ::testing::ValuesIn(cases_up_to(Effort::quick, hydraulics_suite())),
                         case_name);

}  // namespace
}  // namespace wetfront::verification
