// Every case of the suites: minutes.
#include "tests/suites/expect_case.h"

namespace wetfront::verification {
namespace {

using namespace testing;

TEST_P(SuiteCase, Passes) {
  expect_pass(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Reference, SuiteCase, ::testing::ValuesIn(cases_up_to(Effort::heavy, reference_suite())),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Hydraulics, SuiteCase, ::testing::ValuesIn(cases_up_to(Effort::heavy, hydraulics_suite())),
                         case_name);

}  // namespace
}  // namespace wetfront::verification
