// Every case of the reference's suite: minutes.
#include "tests/suites/expect_case.h"

namespace wetfront::verification {
namespace {

using namespace testing;

TEST_P(SuiteCase, Passes) {
  expect_pass(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Reference, SuiteCase, ::testing::ValuesIn(cases_up_to(Effort::heavy)), case_name);

}  // namespace
}  // namespace wetfront::verification
