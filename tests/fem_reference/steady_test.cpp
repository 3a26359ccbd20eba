// Gate R1 of benchmarks.md section 0, soils and numbers of its section 1.9.
#include "tests/fem_reference/columns.h"
#include "verification/exact/steady_infiltration.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;
namespace exact = verification::exact;

RichardsProblem rain_on(int cells, double height, const Soil& soil, double rain) {
  RichardsProblem problem;
  problem.mesh = line_mesh(cells, height);
  problem.gravity_direction = {-1, 0, 0};
  problem.soils = {soil};
  problem.boundary = {RainSide{"top", {{0}, {rain}}}, HeadSide{"base", 0}};
  for (const meshes::Point& node : problem.mesh.nodes) problem.initial_head.push_back(-node[0]);
  problem.end_time = 1;
  return problem;
}

/// L2(psi) relative to the closed form, rain Ks / 2 on 1 m.
double gardner_error(int cells, double alpha) {
  const RichardsProblem problem = rain_on(
      cells, 1, {"Gardner", ExponentialRetention{0.06, 0.4, alpha}, ExponentialConductivity{alpha}, 1e-5, 0, 0}, 5e-6);
  const std::vector<double> head = steady_head(problem);
  const exact::SteadyGardner solution{alpha, 1e-5, 5e-6};
  double error = 0, norm = 0;
  for (int i = 0; i <= cells; ++i) {
    const double expected = solution.head(problem.mesh.nodes[i][0]);
    error += std::pow(head[i] - expected, 2);
    norm += expected * expected;
  }
  return std::sqrt(error / norm);
}

// R1: 2e-6 (alpha L = 1) and 5e-5 (alpha L = 10) at N = 200, order 2.
TEST(GateR1, SteadyGardner) {
  for (double alpha : {1.0, 10.0}) {
    const double e100 = gardner_error(100, alpha), e200 = gardner_error(200, alpha);
    std::printf("  R1 alpha L = %g: rel-L2(psi) %.2e %.2e, order %.3f\n", alpha, e100, e200, std::log2(e100 / e200));
    EXPECT_LE(e200, alpha == 1 ? 2e-6 : 5e-5);
    EXPECT_NEAR(std::log2(e100 / e200), 2, 0.05);
  }
}

// Printed to six digits; 2.5 mm cells.
TEST(GateR1, SteadyVanGenuchten) {
  const double height[] = {.05, .1, .2, .4, .8, 1.2};
  const double at_3e5[] = {-.044789, -.089091, -.174726, -.318918, -.426948, -.435390};
  const double at_half[] = {-.024781, -.048696, -.092207, -.155302, -.199548, -.205439};
  for (const auto& [rain, printed] : {std::pair{3e-5, at_3e5}, {0.5 * 2.943e-4, at_half}}) {
    const std::vector<double> head = steady_head(rain_on(480, 1.2, seed_sand(0.087), rain));
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(head[std::lround(height[i] / 0.0025)], printed[i], 1e-5) << rain << ' ' << height[i];
    }
  }
}

// More rain than the soil takes: ponded at Ks, unit gradient, psi = 0 throughout.
TEST(SteadyHead, PondedColumn) {
  RichardsProblem problem = rain_on(50, 1, seed_sand(0.087), 1e-3);
  for (double head : steady_head(problem)) EXPECT_NEAR(head, 0, 1e-9);
}

// Neither end fixes a head: at the end K(psi) = rain everywhere.
TEST(SteadyHead, UnitGradientAboveFreeDrainage) {
  RichardsProblem problem = rain_on(50, 1, seed_sand(0.087), 3e-5);
  const exact::VanGenuchten soil{0, 1, 9810 / 4350.0, 1 / 0.39, 1};
  problem.boundary[1] = FreeDrainageSide{"base"};
  for (double head : steady_head(problem)) EXPECT_NEAR(soil.relative_conductivity(head) * 2.943e-4, 3e-5, 1e-12);
}

}  // namespace
}  // namespace wetfront::fem_reference
