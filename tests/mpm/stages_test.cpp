// A body that fails, slides and rests in one run: stages that events end, soil and water in true time.
#include "mpm/simulation.h"
#include "tests/mpm/continuation.h"
#include "tests/mpm/small_slope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::mpm {
namespace {

using test::slope;

TEST(Stages, ASlopeFailsSlidesAndRests) {
  Simulation<2> simulation(slope(24, 4));
  double steps_of_rain = 0;
  for (; !simulation.finished(); simulation.step())
    if (simulation.body().stages.size() == 1) ++steps_of_rain;
  const BodyRecord body = simulation.body();
  const auto history = simulation.take_history();
  ASSERT_EQ(body.stages.size(), 2u);
  EXPECT_EQ(body.stages[0].ended_by, "failure") << body.stages[0].reason;
  EXPECT_LT(body.stages[0].end, 600);
  EXPECT_EQ(body.stages[1].begin, body.stages[0].end);
  // The marker moved in the slide, not before it.
  const Rider& rider = body.riders.at(0);
  const auto moved = [&](std::size_t k) {
    return std::hypot(rider.place[k][0] - rider.start[0], rider.place[k][1] - rider.start[1]);
  };
  EXPECT_GT(moved(rider.time.size() - 1), 0.02);
  // Water: what points carry changes by what passes the surface alone, to round-off.
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_NEAR(last.stored - first.stored, last.infiltrated - last.outflow, 1e-9 * last.rain_asked);
  // Rain finds the surface wherever it moves, in every solve of a step (1e-4 measured: where the surface turns over).
  EXPECT_NEAR(last.rain_asked / (2e-4 * 6 * last.time), 1, 1e-3);
  // The water of a body that moves evens out every few cycles of the skeleton.
  EXPECT_LT(history.counters.at("cycles in true time"), 32 * (history.counters.at("steps") - steps_of_rain));
  // Pictures: from the first rain on, no more than twenty before failure, though none were asked for.
  const auto failed = std::ranges::find(body.pictures, "failure", &Picture::of);
  ASSERT_NE(failed, body.pictures.end());
  EXPECT_EQ(body.pictures[0].snapshot.time, 0);
  EXPECT_EQ(body.pictures[0].of, "");
  for (auto before = body.pictures.begin() + 1; before < failed; ++before) {
    EXPECT_GE(before->snapshot.time, 30.0 * static_cast<double>(before - body.pictures.begin()));
    EXPECT_EQ(before->snapshot.points.saturation.size(), before->displacement.size());
  }
  EXPECT_GE(failed - body.pictures.begin(), 5);
  EXPECT_LE(failed - body.pictures.begin(), 21);
  EXPECT_EQ(body.pictures[0].displacement.size(), body.pictures.back().displacement.size());
  ASSERT_FALSE(history.motion.empty());
}

/// Two velocities go on from the balance of forces that seepage held: a full cell that took its pressure from the water
/// its points carry would push ten times its weight. The rain counts on.
TEST(Stages, TwoVelocitiesTakeASlopeOverAtRest) {
  Problem<2> problem = slope(24, 4);
  problem.stages[1].liquid = LiquidScheme::implicit_drag;
  problem.stages[1].ends_with = StageEnd::time;
  problem.stages[1].longest = 0.02;
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  const auto history = simulation.take_history();
  ASSERT_FALSE(history.motion.empty());
  // Full cells take the pressure of their nodes, the others make up for the water that this makes or loses.
  EXPECT_LE(std::abs(history.counters.at("hand-over: stored water change")), 1e-12 * history.ledger.front().stored);
  const double g = 9.81, begins = simulation.body().stages.at(1).begin;
  for (const auto& row : history.motion) {
    const double falls = 0.5 * 7e3 * std::pow(g * std::max(1e-3, row.time - begins), 2);  // J, of 7 t in free fall
    EXPECT_LT(row.kinetic, 0.02 * falls) << row.time - begins;
  }
  const auto& last = history.ledger.back();
  EXPECT_NEAR(last.rain_asked / (2e-4 * 6 * last.time), 1, 1e-3);
}

/// Points that a stage in true time has weighed with their water are grains again for the scheme after it.
TEST(Stages, TwoVelocitiesGoOnWithASlideInTrueTime) {
  Problem<2> problem = slope(24, 4);
  problem.stages[1].ends_with = StageEnd::time;
  problem.stages[1].longest = 0.02;
  Stage split = problem.stages[1];
  split.name = "two velocities";
  split.liquid = LiquidScheme::implicit_drag;
  split.end_time = problem.stages[1].end_time + 1;
  problem.stages.push_back(split);
  Simulation<2> simulation(problem);
  const auto weight = [&simulation] {
    const std::vector<double> mass = simulation.state().fields.at("point.mass");
    return std::accumulate(mass.begin(), mass.end(), 0.0);
  };
  const double grains = weight();
  while (!simulation.finished()) simulation.step();
  ASSERT_EQ(simulation.body().stages.size(), 3u);
  EXPECT_NEAR(weight() / grains, 1, 1e-12);
}

TEST(Stages, ASlopeThatStandsEndsTheRun) {
  Problem<2> problem = slope(12, 2);
  problem.stages[0].end_time = 60;
  problem.stages[0].relaxation.coupling_tolerance = 1e-8;
  problem.stages[1].end_time = 63;
  problem.output_times = {30};
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  EXPECT_EQ(simulation.body().stages.size(), 1u);
  EXPECT_EQ(simulation.body().stages[0].ended_by, "time");
  EXPECT_EQ(simulation.time(), 60);
  // Rain on a surface that settles, in steps that solve the flow several times: all of it.
  const auto history = simulation.take_history();
  EXPECT_NEAR(history.ledger.back().rain_asked / (2e-4 * 6 * 60), 1, 1e-9);
}

TEST(Stages, ACutRunGoesOnWithTheSameBits) {
  Problem<2> problem = slope(12, 2);
  problem.stages[1].longest = 0.5;
  problem.stages[1].picture_every = 0;
  Simulation<2> whole(problem);
  long steps = 0;
  for (; !whole.finished(); ++steps) whole.step();
  test::expect_continuation(problem, std::max(1L, steps / 6), 1);
}

/// Rain on a slope that stands asks for the flow a hundred times less often than motion for a cycle.
TEST(TrueTime, ABodyThatStandsTakesLongStepsOfTheFlow) {
  Problem<2> problem = slope(12, 2);
  problem.stages[0].end_time = 10;
  problem.stages[0].ends_with = problem.stages[1].ends_with = StageEnd::time;
  problem.stages[1].end_time = 14;
  problem.stages[1].longest = 4;
  problem.stages[1].picture_every = 0;
  problem.output_times = {10, 14};
  Simulation<2> simulation(problem);
  double steps = 0;
  for (; !simulation.finished(); simulation.step())
    if (simulation.time() >= 10) ++steps;
  const auto history = simulation.take_history();
  EXPECT_GT(history.counters.at("cycles in true time"), 64 * steps);
  const auto& last = history.ledger.back();
  EXPECT_NEAR(last.stored - history.ledger.front().stored, last.infiltrated - last.outflow, 1e-9 * last.rain_asked);
}

/// A closed box, full, without weight, pressed together from above.
TEST(TrueTime, AFullBoxAnswersUndrained) {
  Problem<2> problem = slope(1, 1);
  problem.mesh = test::box(1, 1, 4, 4);
  problem.surface.clear();
  problem.riders.clear();
  problem.gravity = {0, 0};
  problem.initial_stress = InitialStress::none;
  problem.initial_pressure.assign(problem.mesh.node_count(), 1000);
  problem.water_boundary.clear();
  problem.soils[0].law.reset();
  MovingSide top{"top", {}, {}, "o"};
  top.velocity[1] = -1e-3;
  problem.skeleton_boundary = {top};
  problem.stages = {problem.stages[1]};
  problem.stages[0].ends_with = StageEnd::time;
  problem.stages[0].longest = 0;
  problem.stages[0].picture_every = 0;
  problem.stages[0].end_time = 0.5;
  problem.stages[0].local_damping = 0.1;
  problem.output_times = {0.5};
  const auto history = run<2>(problem);
  const double strain = 1e-3 * 0.5, expected = 1000 + problem.water->bulk_modulus * strain / problem.soils[0].porosity;
  for (const double p : history.snapshots.back().node_pressure) EXPECT_NEAR(p / expected, 1, 0.01);
  // The pores have given way to the water that they hold, to round-off.
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_NEAR(last.stored / first.stored, 1, 1e-12);
}

}  // namespace
}  // namespace wetfront::mpm
