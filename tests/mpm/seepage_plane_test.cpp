// Seepage in two dimensions: no oscillation at fronts, at ponding and in closed boxes on crooked cells with 1, 4 and 9
// points; permeability tensors and factors per cell; storage of a soil.
#include "mpm/simulation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

#include <limits>

namespace wetfront::mpm {
namespace {

struct Grid2 {
  int points;
  bool crooked;
  LiquidScheme scheme;
};

Problem<2> boxed(const Grid2& how, int cells, double end_time) {
  Problem<2> problem = test::seed_column(4, 0.087, 3e-5, end_time);
  problem.mesh = how.crooked ? test::crooked_box(1.2, 1.2, cells, cells) : test::box(1.2, 1.2, cells, cells);
  problem.initial_pressure.assign(problem.mesh.node_count(), -10e3);
  problem.points_per_cell = how.points;
  problem.stages[0].liquid = how.scheme;
  problem.stages[0].time_tolerance = 1e-4;
  problem.output_times = {end_time};
  return problem;
}

double imbalance(const meshes::FieldHistory& history) {
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  return std::abs(last.stored - first.stored - last.infiltrated + last.outflow);
}

class PlaneStability : public ::testing::TestWithParam<Grid2> {};

TEST_P(PlaneStability, NothingSwingsAheadOfTheFront) {
  // Rain of K_s/2 into dry soil: the steepest front. No node may be drier than the soil was, and the rain is level, so
  // pressures at one height stay those of a column to the front's own width.
  Problem<2> problem = boxed(GetParam(), 12, 400);
  problem.initial_pressure.assign(problem.mesh.node_count(), -30e3);
  problem.water_boundary = {RainSide{"top", {{0}, {1.5e-4}}, "test:rain"}, RainSide{"base", {{0}, {0}}, "test:base"}};
  const auto history = run<2>(problem);
  double lowest = 0;
  for (double p : history.snapshots[0].node_pressure) lowest = std::min(lowest, p);
  // Drying by gravity alone at the top of the dry part: K(-30 kPa) = 4e-9 m/s for 400 s.
  EXPECT_GE(lowest, -30e3 - 1);
  EXPECT_LE(imbalance(history), 1e-8 * history.ledger.back().rain_asked);
}

TEST_P(PlaneStability, APondedSurfaceStaysAtZero) {
  Problem<2> problem = boxed(GetParam(), 12, 600);
  problem.water_boundary = {RainSide{"top", {{0}, {6e-4}}, "test:rain"}};
  const auto history = run<2>(problem);
  const auto& last = history.ledger.back();
  ASSERT_GT(last.run_off, 0.05 * last.rain_asked);  // it ponds
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
    if (problem.mesh.nodes[i][1] == 1.2) {
      EXPECT_LE(history.snapshots[0].node_pressure[i], 1.0);
      // What passes the film needs a pressure difference: I h mu/(1e3 k) = 2 Pa in cells of 0.1 m.
      EXPECT_GE(history.snapshots[0].node_pressure[i], -2.1);
    }
}

TEST_P(PlaneStability, AClosedSaturatedBoxRests) {
  for (double bulk_modulus : {2.15e9, std::numeric_limits<double>::infinity()}) {
    Problem<2> problem = boxed(GetParam(), 8, 86400);
    problem.water->bulk_modulus = bulk_modulus;
    problem.water_boundary.clear();
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
      problem.initial_pressure[i] = 5e3 + 9810 * (1.2 - problem.mesh.nodes[i][1]);
    const auto history = run<2>(problem);
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
      EXPECT_NEAR(history.snapshots[0].node_pressure[i], problem.initial_pressure[i], 1e-3) << bulk_modulus;
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, PlaneStability,
                         ::testing::Values(Grid2{1, true, LiquidScheme::seepage}, Grid2{4, true, LiquidScheme::seepage},
                                           Grid2{9, true, LiquidScheme::seepage},
                                           Grid2{4, false, LiquidScheme::seepage},
                                           Grid2{4, true, LiquidScheme::semi_implicit}));

/// Steady flow through a saturated column between pressures held at both ends, per Darcy's of the scalar k.
double relative_flow(const std::array<double, 6>& tensor) {
  Problem<2> problem = test::seed_column(40, 0.087, 0, 1000);
  problem.soils[0].anisotropy = tensor;
  problem.gravity = {};
  problem.initial_pressure.assign(problem.mesh.node_count(), 1e4);
  problem.water_boundary = {PressureSide{"base", 2e4, "test:base"}, PressureSide{"top", 1e4, "test:top"}};
  problem.points_per_cell = 4;
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  // What crosses the middle of the column: -k/mu (T_yy dp/dy + T_xy dp/dx) between its two levels.
  problem.output_times = {1000};
  const auto p = run<2>(problem).snapshots[0].node_pressure;
  const double h = 1.2 / 40, dy = (p[42] + p[43] - p[40] - p[41]) / (2 * h),
               dx = (p[41] + p[43] - p[40] - p[42]) / (2 * h);
  return -(tensor[1] * dy + tensor[3] * dx) / (1e4 / 1.2);
}

TEST(SeepagePlane, AColumnFeelsTheTensorThatItsClosedSidesLeave) {
  EXPECT_NEAR(relative_flow({1, 1, 1, 0, 0, 0}), 1, 1e-6);
  EXPECT_NEAR(relative_flow({7, 3, 1, 0, 0, 0}), 3, 1e-6);
  // No flow across the sides: T_xx dp/dx + T_xy dp/dy = 0 leaves T_yy - T_xy^2/T_xx along the column; at its held ends
  // dp/dx = 0 over about a cell of 40 each: within 5 %. (T_yy alone would be 2.5.)
  EXPECT_NEAR(relative_flow({2.5, 2.5, 1, 1.5, 0, 0}), 1.6, 0.05 * 1.6);
}

TEST(SeepagePlane, AFactorPerCellMultipliesThePermeability) {
  Problem<2> factor = test::seed_column(20, 0.087, 3e-5, 500), permeable = factor;
  factor.output_times = permeable.output_times = {500};
  factor.conductivity_factor.assign(20, 3.0);
  permeable.soils[0].intrinsic_permeability *= 3;
  // Rain on a surface that stays unsaturated: the film's own conductance is not asked.
  const auto a = run<2>(factor), b = run<2>(permeable);
  for (std::size_t i = 0; i < factor.mesh.node_count(); ++i)
    EXPECT_NEAR(a.snapshots[0].node_pressure[i], b.snapshots[0].node_pressure[i], 1e-3) << i;
  factor.conductivity_factor[19] = 0.01;  // a tight cell under the rain ponds
  EXPECT_GT(run<2>(factor).ledger.back().run_off, 0);
}

TEST(SeepagePlane, ASoilsOwnStorageTakesThePlaceOfTheWaters) {
  Problem<2> problem = test::seed_column(20, 0.087, 3e-5, 500);
  problem.initial_pressure.assign(problem.mesh.node_count(), 1e4);
  problem.gravity = {};
  problem.water_boundary = {PressureSide{"top", 2e4, "test:top"}};
  problem.soils[0].storage = 1e-6;
  const auto history = run<2>(problem);
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  const double volume = 1.2 * 0.06;
  EXPECT_NEAR(last.stored - first.stored, volume * 1e-6 * 1e4, 1e-6 * volume * 1e-6 * 1e4);
}

}  // namespace
}  // namespace wetfront::mpm
