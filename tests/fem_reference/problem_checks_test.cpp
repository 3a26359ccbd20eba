#include "tests/fem_reference/columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace wetfront::fem_reference {
namespace {

using namespace testing;
using ::testing::HasSubstr;

void expect_refused(const std::function<void(RichardsProblem&)>& spoil, const std::string& entry) {
  RichardsProblem problem = seed_column(10, 0.87, 3e-5, 100);
  problem.output_times = {50};
  spoil(problem);
  try {
    solve(problem);
    ADD_FAILURE() << "accepted although " << entry << " makes no sense";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(entry));
  }
}

TEST(ProblemChecks, NameTheEntry) {
  expect_refused([](auto& p) { p.soils.clear(); }, "soils");
  expect_refused([](auto& p) { p.soils[0].saturated_conductivity = 0; }, "soils[0] 'sand'.saturated_conductivity");
  expect_refused([](auto& p) { std::get<VanGenuchten>(p.soils[0].retention).n = 1; }, "retention.n");
  expect_refused([](auto& p) { std::get<VanGenuchten>(p.soils[0].retention).theta_r = 0.5; }, "retention.theta_s");
  expect_refused([](auto& p) { p.soils[0].porosity = 0.3; }, "porosity");
  expect_refused([](auto& p) { p.soils[0].specific_storage = -1; }, "specific_storage");
  expect_refused([](auto& p) { p.soils[0].oedometer_modulus = -1; }, "oedometer_modulus");
  expect_refused([](auto& p) { p.conductivity_factor = {1, 2}; }, "conductivity_factor: 2 values");
  expect_refused([](auto& p) { p.conductivity_factor.assign(10, 0.0); }, "conductivity_factor[0]");
  expect_refused(
      [](auto& p) {
        HeadSide base{"base", 0};
        base.total = true;
        base.varying = [](const meshes::Point&, double) { return -1.0; };
        p.boundary.push_back(base);
      },
      "boundary[1] 'base'.varying");
  expect_refused([](auto& p) { p.soils[0].retention = ExponentialRetention{0.1, 0.4, 1}; }, "conductivity");
  expect_refused([](auto& p) { p.soils[0].retention = HaverkampRetention{0.1, 0.4, 0, 4}; }, "retention.a");
  expect_refused([](auto& p) { p.soils[0].retention = BroadbridgeWhiteRetention{0.1, 0.4, 1, 4}; }, "retention.c");
  expect_refused([](auto& p) { p.soils[0].retention = TabulatedRetention{{-1, -0.1}, {0.1, 0.4}}; }, "retention");
  expect_refused([](auto& p) { p.soils[0].retention = TabulatedRetention{{-1, 0}, {0.4, 0.1}}; }, "content[1]");
  expect_refused([](auto& p) { p.soils[0].conductivity = TabulatedConductivity{{-1, 0}, {0, 1}}; }, "relative[0]");
  expect_refused([](auto& p) { p.soils[0].conductivity = BroadbridgeWhiteConductivity{}; }, "conductivity");
  expect_refused([](auto& p) { p.soils[0].conductivity = HaverkampConductivity{1, -1}; }, "conductivity.gamma");
  expect_refused([](auto& p) { std::get<RainSide>(p.boundary[0]).side = "roof"; }, "'roof'");
  expect_refused([](auto& p) { std::get<RainSide>(p.boundary[0]).rain.intensity = {-1}; }, "rain.intensity[0]");
  expect_refused([](auto& p) { std::get<RainSide>(p.boundary[0]).rain.start = {}; }, "rain");
  expect_refused([](auto& p) { p.boundary.push_back(HeadSide{"top", 0}); }, "boundary[1] 'top'");
  expect_refused([](auto& p) { p.initial_head.pop_back(); }, "initial_head");
  expect_refused([](auto& p) { p.initial_head[3] = NAN; }, "initial_head[3]");
  expect_refused([](auto& p) { p.end_time = 0; }, "end_time");
  expect_refused([](auto& p) { p.output_times = {50, 40}; }, "output_times[1]");
  expect_refused([](auto& p) { p.output_times = {150}; }, "output_times[0]");
  expect_refused([](auto& p) { p.gravity_direction = {-2, 0, 0}; }, "gravity_direction");
  expect_refused([](auto& p) { p.tolerance = 0; }, "tolerance");
  expect_refused([](auto& p) { p.degree = 0; }, "degree");
  expect_refused([](auto& p) { p.gauges = {{"well", {3, 0, 0}}}; }, "gauge 'well'");
}

// exp(-800) underflows: at -1 m this soil has no capacity and no conductivity left, so the Jacobian is singular as soon
// as rain asks for a change, and no step size helps.
TEST(GaveUp, SaysWhereAndKeepsThePartialResult) {
  for (Integrator integrator : {Integrator::bdf, Integrator::backward_euler}) {
    RichardsProblem problem = seed_column(20, 0.087, 0, 1000);
    problem.boundary = {RainSide{"top", {{500}, {1e-3}}}};
    problem.soils = {{"absurd", ExponentialRetention{0.1, 0.4, 800}, ExponentialConductivity{800}, 1e-4, 0, 0}};
    problem.initial_head.assign(21, -1.0);
    problem.output_times = {250, 1000};
    problem.integrator = integrator;
    try {
      solve(problem);
      ADD_FAILURE() << "solved the unsolvable";
    } catch (const GaveUp& failure) {
      EXPECT_THAT(failure.what(), HasSubstr("element"));
      EXPECT_THAT(failure.what(), HasSubstr("pressure head"));
      EXPECT_THAT(failure.what(), HasSubstr("residuals"));
      EXPECT_EQ(failure.partial.snapshots.size(), 1U);
      EXPECT_EQ(failure.partial.ledger.back().time, 500);
      EXPECT_FALSE(failure.partial.log.empty());
      std::printf("  %s\n", failure.what());
    }
  }
}

double rain_volume(const meshes::FieldHistory& h) {
  return h.ledger.back().rain_asked;
}

TEST(Boundaries, RainBreaksAreSteppedOnto) {
  RichardsProblem problem = seed_column(60, 0.87, 0, 400);
  problem.boundary = {RainSide{"top", {{10, 60.5, 200, 333.3}, {1e-4, 0, 3e-4, 0}}}};
  const meshes::FieldHistory history = solve(problem);
  EXPECT_NEAR(rain_volume(history), 50.5 * 1e-4 + 133.3 * 3e-4, 1e-15);
  for (double t : {10.0, 60.5, 200.0, 333.3}) {
    EXPECT_TRUE(std::any_of(history.ledger.begin(), history.ledger.end(), [&](auto& row) { return row.time == t; }));
  }
  EXPECT_LE(worst_imbalance(history), 1e-8);
}

// A head above the surface value pours water in; what came in is a negative outflow.
TEST(Boundaries, HeadSideLetsWaterIn) {
  RichardsProblem problem = seed_column(60, 0.87, 0, 2000);
  problem.boundary = {HeadSide{"top", 0.1}};
  problem.initial_head.assign(61, -1.0);
  const meshes::FieldHistory history = solve(problem);
  EXPECT_LT(history.ledger.back().outflow, 0);
  EXPECT_LE(worst_imbalance(history), 1e-8);
  EXPECT_EQ(history.log.size(), 1U);  // the jump at t = 0 is told
}

// A column under water at the start contradicts the rain side's psi <= 0: the surface node lets go of it at once.
TEST(Boundaries, InconsistentStartIsInTheLedger) {
  RichardsProblem problem = seed_column(60, 0.87, 1e-5, 50);
  for (std::size_t i = 0; i < problem.mesh.nodes.size(); ++i) {
    problem.initial_head[i] = 1.5 - problem.mesh.nodes[i][0];
  }
  const meshes::FieldHistory history = solve(problem);
  EXPECT_FALSE(history.log.empty());
  EXPECT_GT(history.ledger.back().outflow, 0);
  // At rest with the water table at the surface: 1.2 m of head at the base; all the rain runs off.
  const double released = history.ledger.front().stored - history.ledger.back().stored;
  EXPECT_NEAR(released, history.ledger.back().outflow - history.ledger.back().infiltrated, 1e-12);
  EXPECT_NEAR(history.ledger.back().run_off, 50e-5, 1e-8);
}

// A side without rain is a seepage face: a full column drains through its foot down to psi = 0 there.
TEST(Boundaries, SeepageFace) {
  RichardsProblem problem = seed_column(60, 0.087, 0, 20000);
  problem.boundary = {RainSide{"base", {}}};
  problem.initial_head.assign(61, 0.0);
  problem.gauges = {{"base", {0, 0, 0}}};
  const meshes::FieldHistory history = solve(problem);
  EXPECT_GT(history.ledger.back().outflow, 0.01);
  EXPECT_EQ(history.ledger.back().run_off, 0);
  EXPECT_EQ(history.gauges[0].pressure.back(), 0);
  EXPECT_LE(worst_imbalance(history), 1e-8);
}

}  // namespace
}  // namespace wetfront::fem_reference
