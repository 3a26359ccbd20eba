// What a scene calls for is planned, and nothing else: columns, kernels, bytes, refusals.
#include "mpm/plan/derive_effects.h"
#include "mpm/simulation.h"
#include "tests/mpm/strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wetfront::mpm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Problem<2> dry_column() {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.water.reset();
  problem.initial_pressure.clear();
  problem.water_boundary.clear();
  problem.soils[0].retention.reset();
  problem.soils[0].permeability.reset();
  problem.soils[0].elastic = Elastic{10e6, 0.3, "test:elastic"};
  problem.stages[0].liquid.reset();
  problem.stages[0].local_damping = 0.1;
  problem.fixities = {{"base", {true, true, false}, "test:base"}};
  return problem;
}

std::string refusal(const Problem<2>& problem) {
  try {
    plan(problem);
  } catch (const CannotPlan& refused) {
    return refused.what();
  }
  return "";
}

std::vector<std::string> names(const PlanInfo& info) {
  std::vector<std::string> all;
  for (const auto& column : info.columns) all.push_back(column.name);
  for (const auto& kernel : info.kernels) all.push_back(kernel.name);
  return all;
}

TEST(Plan, ADrySceneHasNoWaterColumnAndNoWaterKernel) {
  const PlanInfo info = plan(dry_column()).at(0);
  for (const std::string& name : names(info))
    for (const char* word : {"water", "pressure", "saturation", "liquid", "rain", "Darcy", "storage", "outflow"})
      EXPECT_THAT(name, Not(HasSubstr(word)));
  EXPECT_EQ(info.scheme, "gravity + deforming skeleton + motion ledger");
  // position 2, volume 1, mass 1, velocity 2, stress 4, migration 1: 11 numbers.
  EXPECT_EQ(info.bytes_per_point, 11 * sizeof(double));
  // The nodes carry no water either.
  Fields<2> fields(dry_column());
  const Problem<2> problem = dry_column();
  make_plan(problem, 0, fields)->enter();
  for (const char* column : {"pressure", "stored water", "outflow"})
    EXPECT_EQ(fields.grid.columns.find(column), nullptr);
}

TEST(Plan, ARigidInfiltrationSceneHasNoMechanics) {
  const PlanInfo info = plan(test::seed_column(10, 0.087, 3e-5, 1.0)).at(0);
  for (const std::string& name : names(info))
    for (const char* word : {"velocity", "stress", "mass", "migration", "drainage"})
      EXPECT_THAT(name, Not(HasSubstr(word)));
  EXPECT_EQ(info.scheme, "gravity + rigid skeleton + seepage + rainfall");
  EXPECT_EQ(info.bytes_per_point, (2 + 1 + 4 + 8 + 1 + 1) * sizeof(double));
}

TEST(Plan, BytesPerPointAreWhatIsAllocated) {
  for (const Problem<2>& problem : {test::seed_column(10, 0.087, 3e-5, 1.0), dry_column()}) {
    Fields<2> fields(problem);
    const auto made = make_plan(problem, 0, fields);
    made->enter();
    std::size_t bytes = 0;
    for (const auto& column : fields.points.columns.all()) bytes += column->values().size_bytes();
    const PlanInfo info = made->info();
    EXPECT_EQ(info.bytes_per_point * info.slots, bytes);
    EXPECT_EQ(info.point_bytes, bytes);
    EXPECT_GE(info.slots, info.points);
  }
}

TEST(Plan, AnEffectThatIsNotCalledForIsNotThere) {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.water_boundary.clear();
  problem.gravity = {0, 0};
  EXPECT_EQ(plan(problem).at(0).scheme, "rigid skeleton + seepage");
  problem.water_boundary = {PressureSide{"base", 0, "o"}};
  problem.probes = {{"P", {0.01, 0.1, 0}, "o"}};
  EXPECT_EQ(plan(problem).at(0).scheme, "rigid skeleton + seepage + prescribed pressure + probes");
}

TEST(Plan, KernelsRunInTheOrderOfTheirPhases) {
  const PlanInfo info = plan(dry_column()).at(0);
  std::vector<std::string> phases;
  for (const auto& kernel : info.kernels)
    if (phases.empty() || phases.back() != kernel.phase) phases.push_back(kernel.phase);
  // Strain, stress and motion of a deforming skeleton are one fused kernel.
  EXPECT_THAT(phases,
              ::testing::ElementsAre("I gather", "II accelerate", "III point velocity", "VIII move", "IX carry"));
}

TEST(Plan, ColumnsThatTheNextStageDoesNotNeedAreFreed) {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  Stage dry = problem.stages[0];
  dry.liquid.reset();
  dry.end_time = 2;
  problem.stages.push_back(dry);
  const auto infos = plan(problem);
  EXPECT_GT(infos[0].bytes_per_point, infos[1].bytes_per_point);
  EXPECT_THAT(infos[1].columns, Not(::testing::Contains(::testing::Field(&ColumnInfo::name, "saturation"))));
}

/// An effect that wants a column which nobody has.
struct Thirsty : Effect<2> {
  Thirsty() : Effect<2>("rainfall", "o", "") {}
  void join(StagePlan<2>& plan) override { plan.require_on_points("liquid velocity"); }
};

TEST(Plan, SaysWhoNeedsWhatNobodyProvides) {
  const Problem<2> problem = dry_column();
  Fields<2> fields(problem);
  StagePlan<2> stage_plan(problem, 0, fields);
  stage_plan.join(std::make_unique<Thirsty>());
  try {
    stage_plan.check();
    FAIL();
  } catch (const CannotPlan& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("rainfall needs 'liquid velocity' but no effect of this scene provides it"));
  }
}

TEST(Plan, RefusesRainThatCannotFall) {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.water_boundary = {RainSide{"roof", {{0.0}, {3e-5}}, "scene:7"}};
  EXPECT_THAT(refusal(problem), AllOf(HasSubstr("scene:7"), HasSubstr("'roof'"), HasSubstr("'base', 'top'")));
  problem.water_boundary = {RainSide{"left", {{0.0}, {3e-5}}, "scene:7"}};
  EXPECT_THAT(refusal(problem), HasSubstr("vertical or faces downwards"));
  problem.water_boundary = {RainSide{"base", {{0.0}, {3e-5}}, "scene:7"}};
  EXPECT_THAT(refusal(problem), HasSubstr("vertical or faces downwards"));
}

TEST(Plan, RefusesSeepageAfterTwoVelocities) {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.stages[0].liquid = LiquidScheme::implicit_drag;
  problem.stages.push_back(problem.stages[0]);
  problem.stages[1].end_time = 2;
  EXPECT_EQ(refusal(problem), "");
  problem.stages[1].liquid = LiquidScheme::seepage;
  EXPECT_THAT(refusal(problem), HasSubstr("Put the seepage stages first"));
}

TEST(Plan, RefusesRainWithNoSoilBehind) {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  Fields<2> fields(problem);
  std::vector<std::size_t> counts(10, 4);
  counts.back() = 0;  // the points of the top cell are gone
  fields.points.set_counts(fields.grid, counts);
  EXPECT_THROW(
      {
        try {
          make_plan(problem, 0, fields);
        } catch (const CannotPlan& refused) {
          EXPECT_THAT(refused.what(), HasSubstr("no cell behind that side holds a material point"));
          throw;
        }
      },
      CannotPlan);
}

TEST(Plan, RefusesWhatDoesNotGoTogether) {
  Problem<2> problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.soils[0].elastic = Elastic{10e6, 0.3, "o"};
  problem.stages[0].liquid = LiquidScheme::semi_implicit;
  problem.stages[0].motion = SkeletonMotion::quasi_static;
  EXPECT_THAT(refusal(problem), HasSubstr("semi-implicit with quasi-static motion"));
  problem.stages[0].motion = SkeletonMotion::dynamic;
  problem.skeleton.update = StressUpdate::usl;
  EXPECT_THAT(refusal(problem), HasSubstr("stable with MUSL only"));
  problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.water.reset();
  EXPECT_THAT(refusal(problem), HasSubstr("no water"));
  problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.probes = {{"far", {5, 5, 0}, "scene:9"}};
  EXPECT_THAT(refusal(problem), AllOf(HasSubstr("scene:9"), HasSubstr("outside the soil")));
  problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.soils[0].retention.reset();
  EXPECT_THAT(refusal(problem), HasSubstr("no retention curve"));
  problem = test::seed_column(10, 0.087, 3e-5, 1.0);
  problem.initial_pressure.pop_back();
  EXPECT_THAT(refusal(problem), HasSubstr("initial pressure"));
}

}  // namespace
}  // namespace wetfront::mpm
