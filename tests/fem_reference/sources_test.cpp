// Sources, heads that vary in place and time, conductivity cell by cell.
#include "tests/fem_reference/columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

/// psi = -1 + 0.4 sin(3 z) cos(t / 500), z up, in Gardner's soil; the source that this takes, by hand.
struct Manufactured {
  double alpha = 2, conductivity = 1e-4, range = 0.3;
  double head(double z, double t) const { return -1 + 0.4 * std::sin(3 * z) * std::cos(t / 500); }
  double source(double z, double t) const {
    const double psi = head(z, t), relative = std::exp(alpha * psi);
    const double rate = -0.4 * std::sin(3 * z) * std::sin(t / 500) / 500;
    const double slope = 1.2 * std::cos(3 * z) * std::cos(t / 500), curve = -3.6 * std::sin(3 * z) * std::cos(t / 500);
    return range * alpha * relative * rate - conductivity * relative * (alpha * slope * (slope + 1) + curve);
  }
};

meshes::FieldHistory manufactured_run(int cells, Integrator integrator, double tolerance) {
  const Manufactured law;
  RichardsProblem problem;
  problem.mesh = line_mesh(cells, 1);
  problem.gravity_direction = {-1, 0, 0};
  problem.soils = {{"Gardner", ExponentialRetention{0.1, 0.1 + law.range, law.alpha},
                    ExponentialConductivity{law.alpha}, law.conductivity, 0, 0}};
  for (const char* side : {"base", "top"}) {
    HeadSide head{side, 0};
    head.varying = [law](const meshes::Point& x, double t) { return law.head(x[0], t); };
    problem.boundary.emplace_back(head);
  }
  problem.source = [law](const meshes::Point& x, double t) { return law.source(x[0], t); };
  for (const meshes::Point& node : problem.mesh.nodes) problem.initial_head.push_back(law.head(node[0], 0));
  problem.end_time = 1000;
  problem.output_times = {300, 1000};
  problem.tolerance = tolerance;
  problem.integrator = integrator;
  return solve(problem);
}

double manufactured_error(int cells, double* imbalance) {
  const meshes::FieldHistory history = manufactured_run(cells, Integrator::bdf, 1e-8);
  *imbalance = worst_imbalance(history);
  double worst = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    for (int i = 0; i <= cells; ++i) {
      const double exact = Manufactured().head(history.mesh.nodes[i][0], snapshot.time);
      worst = std::max(worst, std::abs(snapshot.node_pressure[i] / 9810 - exact));
    }
  }
  EXPECT_NE(history.counters.at("source"), 0);
  return worst;
}

// Order 2 in space, which a source or a head at the wrong time or place spoils at once; and what comes up inside is in
// the ledger.
TEST(Manufactured, SourceAndVaryingHeadsConvergeWithOrderTwo) {
  double imbalance = 0;
  const double coarse = manufactured_error(20, &imbalance), fine = manufactured_error(40, &imbalance);
  std::printf("  manufactured: max |psi| error %.2e %.2e, order %.3f, imbalance %.1e\n", coarse, fine,
              std::log2(coarse / fine), imbalance);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  EXPECT_LE(fine, 2e-4);
  EXPECT_LE(imbalance, 1e-8);
}

/// Two soils that differ by Ks, as soils and as a factor, over free drainage through both.
TEST(ConductivityFactor, IsAnotherSoil) {
  meshes::FieldHistory record[2];
  for (int way : {0, 1}) {
    RichardsProblem problem = seed_column(8, 0.087, 3e-5, 2000);
    problem.mesh = strip_mesh(8, 1.2, 2);
    problem.gravity_direction = {0, -1, 0};
    problem.initial_head.assign(problem.mesh.node_count(), -0.5);
    problem.boundary.push_back(FreeDrainageSide{"base"});
    problem.output_times = {2000};
    const auto coarse = [](int c) { return c % 2 == 1 || c >= 12; };
    if (way == 0) {
      problem.mesh.region_names = {"fine", "coarse"};
      problem.soils.push_back(problem.soils[0]);
      problem.soils[1].saturated_conductivity *= 20;
      for (int c = 0; c < 16; ++c) problem.mesh.region[c] = coarse(c) ? 1 : 0;
    } else {
      for (int c = 0; c < 16; ++c) problem.conductivity_factor.push_back(coarse(c) ? 20 : 1);
    }
    record[way] = solve(problem);
  }
  for (std::size_t i = 0; i < record[0].mesh.node_count(); ++i) {
    const double soils = record[0].snapshots[0].node_pressure[i], factor = record[1].snapshots[0].node_pressure[i];
    EXPECT_NEAR(soils, factor, 1e-4 * std::abs(soils)) << i;  // the two runs differ by rounding, hence by the tolerance
  }
  EXPECT_NEAR(record[0].ledger.back().outflow, record[1].ledger.back().outflow, 1e-8);
  EXPECT_GT(record[0].ledger.back().outflow, 1e-3);
}

}  // namespace
}  // namespace wetfront::fem_reference
