// What each integrator's tolerance buys, on a smooth case on one mesh: a closed column of Gardner's soil in which water
// settles, against the same mesh at a far tighter tolerance, so that the mesh does not count.
#include "tests/fem_reference/columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

RichardsProblem smooth_column(Integrator integrator, double tolerance) {
  RichardsProblem problem;
  problem.mesh = line_mesh(10, 1);
  problem.gravity_direction = {-1, 0, 0};
  problem.soils = {{"Gardner", ExponentialRetention{0.06, 0.4, 1}, ExponentialConductivity{1}, 2.78e-6, 0, 0}};
  for (const meshes::Point& node : problem.mesh.nodes) {
    problem.initial_head.push_back(-1 + 0.3 * std::cos(3 * node[0]));
  }
  problem.end_time = 1e4;
  problem.output_times = {1e4};
  problem.integrator = integrator;
  problem.tolerance = tolerance;
  return problem;
}

struct Run {
  double error, steps;
};

Run run(Integrator integrator, double tolerance) {
  static const meshes::FieldHistory reference = solve(smooth_column(Integrator::dirk, 1e-9));
  const meshes::FieldHistory history = solve(smooth_column(integrator, tolerance));
  double worst = 0;
  for (std::size_t i = 0; i < reference.mesh.node_count(); ++i) {
    worst = std::max(worst, std::abs(history.snapshots[0].node_pressure[i] - reference.snapshots[0].node_pressure[i]));
  }
  // Each stage may miss W by 1e-12, and a run has hundreds.
  EXPECT_NEAR(history.ledger.back().stored, history.ledger.front().stored, 1e-9);
  return {worst / 9810, history.counters.at("steps")};
}

/// Slope of log error over log 1/steps between two tolerances.
double observed_order(const char* name, Integrator integrator, double loose, double tight) {
  const Run a = run(integrator, loose), b = run(integrator, tight);
  const double order = std::log(a.error / b.error) / std::log(b.steps / a.steps);
  std::printf("  %s: %.0f steps %.2e m, %.0f steps %.2e m, order %.2f\n", name, a.steps, a.error, b.steps, b.error,
              order);
  return order;
}

// 0.3 below the order of the method: the controllers do not keep the steps' proportions exactly.
TEST(TimeOrder, BackwardEulerIsOfOrderOne) {
  EXPECT_NEAR(observed_order("backward Euler", Integrator::backward_euler, 1e-4, 1e-6), 1, 0.3);
}
TEST(TimeOrder, DirkIsOfOrderFour) {
  EXPECT_GE(observed_order("SDIRK(5,3,4)", Integrator::dirk, 1e-4, 1e-7), 3.7);
}
// BDF chooses its order; its error goes with the tolerance, within a factor of ten over three decades.
TEST(TimeOrder, BdfFollowsTheTolerance) {
  const double loose = run(Integrator::bdf, 1e-4).error, tight = run(Integrator::bdf, 1e-7).error;
  std::printf("  BDF: %.2e m at 1e-4, %.2e m at 1e-7\n", loose, tight);
  EXPECT_LE(tight, 1e-2 * loose);
  EXPECT_LE(loose, 1e-3);
}

// Through ponding, to saturation and past it: DIRK against BDF, and the balance.
TEST(TimeOrder, DirkFillsTheSeedColumnAsBdfDoes) {
  for (double sigma : {2.2563e-5, 0.0}) {
    meshes::FieldHistory history[2];
    for (int way : {0, 1}) {
      RichardsProblem problem = seed_column(120, 0.87, 3e-4, 300);
      problem.soils[0].specific_storage = sigma;
      problem.integrator = way == 0 ? Integrator::bdf : Integrator::dirk;
      problem.output_times = {100, 300};
      history[way] = solve(problem);
      EXPECT_LE(worst_imbalance(history[way]), 1e-8);
      EXPECT_GT(history[way].ledger.back().run_off, 0);
    }
    for (int s : {0, 1}) {
      for (std::size_t i = 0; i < history[0].mesh.node_count(); ++i) {
        // W to 1e-6 relative is about 1e-5 m of head in this soil, more near saturation where W is flat.
        EXPECT_NEAR(history[0].snapshots[s].node_pressure[i], history[1].snapshots[s].node_pressure[i], 1e-4 * 9810);
      }
    }
  }
}

}  // namespace
}  // namespace wetfront::fem_reference
