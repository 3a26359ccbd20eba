#include "tests/mpm/two_velocity_limit_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// The step limits of the two-velocity schemes: stable at 0.9 of the formula, and blow-up found where it must be.
/// (two_velocity_bisection_test.cpp finds the limits themselves.)
namespace wetfront::mpm::test {
namespace {

using testing::AllOf, testing::HasSubstr;

class StepLimit : public testing::TestWithParam<LiquidScheme> {};
TEST_P(StepLimit, StableBelowAndBlowUpFoundAbove) {
  for (const Body& body : bodies())
    for (const Condition& condition : conditions) {
      Problem<2> problem = uniform_body(body.mesh, condition.pressure, GetParam());
      problem.soils[0].intrinsic_permeability = condition.permeability;
      const Trial good = run_at(problem, 0.9, 200), bad = run_at(problem, 1.2 * 1.5, 200);
      const std::string where = std::string(body.name) + ", " + condition.name;
      EXPECT_EQ(good.stopped, "") << where;
      EXPECT_LT(good.growth, 2) << where << ": beats of modes that gravel hardly damps reach 1.3";
      EXPECT_THAT(bad.stopped, AllOf(HasSubstr("blown up"), HasSubstr(") m"), HasSubstr("times the step limit")))
          << where;
    }
}
INSTANTIATE_TEST_SUITE_P(Drag, StepLimit, testing::Values(LiquidScheme::implicit_drag, LiquidScheme::explicit_drag),
                         scheme_of_test);

}  // namespace
}  // namespace wetfront::mpm::test
