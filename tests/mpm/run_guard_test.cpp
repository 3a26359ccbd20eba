// A run never hangs, crawls or carries on with what cannot be: estimate, budget, the net under the fields.
#include "mpm/record/run_guard.h"
#include "mpm/plan.h"
#include "mpm/plan/derive_effects.h"
#include "mpm/plan/estimate.h"
#include "mpm/simulation.h"
#include "tests/mpm/two_velocity_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace wetfront::mpm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const Problem<2>& problem) {
  try {
    run(problem);
  } catch (const CannotPlan& refused) {
    return refused.what();
  }
  return "";
}

TEST(Estimate, CountsTheStepsOfARunToAFactorOfFour) {
  // A window behind seepage, a filling column (stiff at its end) and one at rest.
  Problem<2> filling = test::with_two_velocities(test::seed_column(6, 0.87, 3e-4, 130));
  for (const Problem<2>& problem : {test::window(20, 0.87, 1.5e-4, 0.41), filling, test::at_rest(10, 10)}) {
    SCOPED_TRACE(problem.mesh.cell_count());
    double expected = 0;
    for (const PlanInfo& stage : plan(problem))
      if (stage.scheme.find("seepage") == std::string::npos) expected += stage.estimated_steps;
    Simulation<2> simulation(problem);
    long steps = 0;
    while (!simulation.finished()) {
      simulation.step();
      steps += problem.stages.size() == 1 || simulation.state().stage == 1;
    }
    EXPECT_LT(expected / static_cast<double>(steps), 4.0);
    EXPECT_GT(expected / static_cast<double>(steps), 1 / 4.0);
  }
}

TEST(Estimate, RefusesWhatCostsMoreThanTheBudget) {
  Problem<2> problem = test::with_two_velocities(test::seed_column(40, 0.87, 3e-5, 9000));
  problem.cpu_budget = 10;
  const std::string text = refusal(problem);
  EXPECT_THAT(text, AllOf(HasSubstr("test:stage"), HasSubstr("too expensive: about"), HasSubstr("steps of dt ="),
                          HasSubstr("h of CPU; budget 10 s"), HasSubstr("Use the scheme seepage")));
  EXPECT_THROW(plan(problem), CannotPlan);
  problem.cpu_budget = 0;
  EXPECT_NO_THROW(plan(problem));
  // Seepage is never refused for its cost, and runs within it.
  problem = test::seed_column(40, 0.87, 3e-5, 900);
  problem.cpu_budget = 10;
  EXPECT_EQ(refusal(problem), "");
}

TEST(RunGuard, StopsAtTheBudgetAndKeepsWhatThereIs) {
  Problem<2> problem = test::seed_column(100, 0.87, 3e-5, 9000);
  problem.output_times = {0};
  problem.cpu_budget = 0.01;
  try {
    run(problem);
    FAIL() << "a hundredth of a second is not enough";
  } catch (const GaveUp& failure) {
    EXPECT_THAT(failure.what(),
                AllOf(HasSubstr("its budget is 0.01 s"), HasSubstr("time went to"), HasSubstr("% done")));
    EXPECT_EQ(failure.partial.snapshots.size(), 1u);
    EXPECT_GT(failure.partial.ledger.size(), 1u);
    EXPECT_GT(failure.partial.cpu_seconds, 0.01);
    EXPECT_LT(failure.partial.cpu_seconds, 1.0);
  }
}

/// The guard over a plan whose fields the test spoils.
struct Spoilt {
  Problem<2> problem;
  Fields<2> fields;
  std::unique_ptr<StagePlan<2>> plan;
  RunGuard<2> guard;

  explicit Spoilt(const Problem<2>& p)
      : problem(p), fields(problem), plan(entered()), guard(*plan, {0, thread_cpu_seconds()}, [] { return 100.0; }) {}
  std::unique_ptr<StagePlan<2>> entered() {
    auto made = make_plan(problem, 0, fields);
    made->enter();
    return made;
  }
  std::string complaint(long step = 0) {
    try {
      guard.after_step(step);
    } catch (const StepFailed& failure) {
      return failure.what();
    }
    return "";
  }
};

TEST(RunGuard, FindsWhatIsNotANumberAndSaysWhere) {
  Spoilt seepage(test::seed_column(10, 0.087, 3e-5, 10));
  EXPECT_EQ(seepage.complaint(), "");
  seepage.fields.grid.columns.at("pressure")[0][7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(seepage.complaint(), AllOf(HasSubstr("node 7"), HasSubstr("0.36 m"),
                                         HasSubstr("pressure is not a number"), HasSubstr("limit of stability")));
  Spoilt drag(test::with_two_velocities(test::seed_column(10, 0.087, 3e-5, 10)));
  EXPECT_EQ(drag.complaint(), "");
  drag.fields.points.columns.at("liquid velocity")[1][5] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(drag.complaint(), AllOf(HasSubstr("point 5"), HasSubstr("liquid velocity is not a number")));
  EXPECT_EQ(drag.complaint(1), "") << "between two scans only the ledger is looked at";
  drag.fields.run.at("water ledger")[4][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(drag.complaint(1), HasSubstr("not a number"));
}

TEST(RunGuard, HoldsPressuresToWhatHeadsCanCause) {
  // 1.2 m under rain, start at -10 kPa and wetter: heads lie between the base and the surface, 11.8 kPa apart.
  Spoilt run(test::seed_column(10, 0.087, 3e-5, 10));
  double& p = run.fields.grid.columns.at("pressure")[0][0];
  p = 11.7e3;
  EXPECT_EQ(run.complaint(), "");
  meshes::FieldHistory history;
  run.guard.tell(history);
  EXPECT_EQ(history.counters.at("pressure beyond heads [Pa]"), 0);
  p = 12e3;
  EXPECT_EQ(run.complaint(), "") << "228 Pa beyond: told, not stopped";
  run.guard.tell(history);
  EXPECT_NEAR(history.counters.at("pressure beyond heads [Pa]"), 12e3 - 9810 * 1.2, 1e-6);
  p = 30e3;
  EXPECT_THAT(run.complaint(),
              AllOf(HasSubstr("pressure is 3e+04 Pa"), HasSubstr("heads of this scene"), HasSubstr("node 0")));
  p = -40e3;
  EXPECT_THAT(run.complaint(), HasSubstr("heads of this scene"));
}

TEST(RunGuard, HoldsTheLiquidsEnergyToWhatHeadsCanGive) {
  Spoilt run(test::with_two_velocities(test::seed_column(10, 0.087, 3e-5, 10)));
  Column& velocity = run.fields.points.columns.at("liquid velocity");
  velocity.fill(0.1);
  EXPECT_EQ(run.complaint(), "");
  velocity.fill(10);
  EXPECT_THAT(run.complaint(), HasSubstr("the liquid moves with"));
}

TEST(RunGuard, SeesARunThatCrawls) {
  const auto complaint = [](double dt) {
    Spoilt run(test::seed_column(10, 0.087, 3e-5, 1000));  // ten million steps of 0.1 ms are too many
    try {
      for (long step = 0; step <= 1000; ++step) {
        run.guard.before_step(step);
        run.plan->clock.end += dt;
      }
    } catch (const StepFailed& failure) {
      return std::string(failure.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(1e-3), "");
  EXPECT_THAT(complaint(9e-5), AllOf(HasSubstr("the run crawls: the last 1000 steps were 9e-05 s on average"),
                                     HasSubstr("1.11e+07 such steps are left")));
}

/// Judged at a sixteenth of the steps and by sums, the net costs a hundredth of the smallest step.
TEST(RunGuard, CostsNextToNothing) {
  Spoilt run(test::with_two_velocities(test::seed_column(40, 0.087, 3e-5, 10)));
  run.plan->clock.dt = 1e-6;
  constexpr long rounds = 4000;
  double start = thread_cpu_seconds();
  for (long step = 0; step < rounds; ++step) run.guard.after_step(step);
  const double guard = thread_cpu_seconds() - start;
  start = thread_cpu_seconds();
  for (long step = 0; step < rounds / 10; ++step) run.plan->run_step();
  const double steps = 10 * (thread_cpu_seconds() - start);
  RecordProperty("guard_us_per_step", std::to_string(1e6 * guard / rounds));
  RecordProperty("step_us", std::to_string(1e6 * steps / rounds));
  EXPECT_LT(guard, 0.02 * steps) << 1e6 * guard / rounds << " us of " << 1e6 * steps / rounds << " us";
}

}  // namespace
}  // namespace wetfront::mpm
