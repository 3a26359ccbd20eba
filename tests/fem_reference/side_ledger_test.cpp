#include "tests/fem_reference/columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

const meshes::SideLedger& line(const meshes::FieldHistory& history, const std::string& side) {
  for (const meshes::SideLedger& ledger : history.sides) {
    if (ledger.side == side) return ledger;
  }
  throw std::out_of_range(side);
}

/// Rain and evaporation on the top, water offered to the left, free drainage below, a head on the right.
RichardsProblem four_sides() {
  RichardsProblem problem = seed_column(4, 0, 0, 600);
  problem.mesh = strip_mesh(12, 1.2, 6);
  problem.gravity_direction = {0, -1, 0};
  problem.initial_head.assign(problem.mesh.node_count(), -1.0);
  problem.boundary = {RainSide{"top", {{0, 200}, {4e-4, 0}}, {{0, 300}, {0, 2e-5}}, -2},
                      FluxSide{"left", {{0, 300}, {8e-4, 0}}}, FreeDrainageSide{"base"}, HeadSide{"right", -0.8}};
  problem.output_times = {};
  return problem;
}

// The row's columns are the sums of the sides' lines; rounding of some thousand additions.
TEST(SideLedger, SumsToTheLedger) {
  const meshes::FieldHistory history = solve(four_sides());
  ASSERT_EQ(history.sides.size(), 4U);
  for (std::size_t i = 0; i < history.ledger.size(); ++i) {
    double asked = 0, run_off = 0, outflow = 0;
    for (const meshes::SideLedger& side : history.sides) {
      ASSERT_EQ(side.asked.size(), history.ledger.size());
      asked += side.asked[i];
      run_off += side.run_off[i];
      outflow += side.outflow[i] + side.evaporated[i];
    }
    EXPECT_NEAR(asked, history.ledger[i].rain_asked, 1e-14);
    EXPECT_NEAR(run_off, history.ledger[i].run_off, 1e-14);
    EXPECT_NEAR(outflow, history.ledger[i].outflow, 1e-14);
  }
  EXPECT_LE(worst_imbalance(history), 1e-8);
}

TEST(SideLedger, TellsTheSidesApart) {
  const meshes::FieldHistory history = solve(four_sides());
  const meshes::SideLedger &top = line(history, "top"), &left = line(history, "left");
  EXPECT_EQ(top.condition, "rain");
  EXPECT_EQ(left.condition, "flux");
  // The node in the right corner is held at a head: its half cell of rain, 1/12 m, is not asked for.
  EXPECT_NEAR(top.asked.back(), 200 * 4e-4 * 11.0 / 12, 1e-14);
  EXPECT_NEAR(left.asked.back(), 300 * 8e-4 * 1.2, 1e-14);
  EXPECT_NEAR(top.demanded.back(), 300 * 2e-5 * 11.0 / 12, 1e-14);
  EXPECT_GT(top.evaporated.back(), 0);
  EXPECT_EQ(left.evaporated.back(), 0);
  EXPECT_GT(left.run_off.back(), 0);  // 2.7 Ks
  EXPECT_GT(line(history, "base").outflow.back(), 0);
  EXPECT_EQ(line(history, "right").asked.back(), 0);
  for (std::size_t i = 1; i < top.asked.size(); ++i) {
    EXPECT_GE(top.run_off[i], top.run_off[i - 1]);
    EXPECT_LE(top.run_off[i], top.asked[i]);
    EXPECT_LE(top.evaporated[i], top.demanded[i] * (1 + 1e-12));
  }
}

// Where nearly nothing enters, each side refuses what it was offered, also at the corner that they share. Filling the
// nodes of the sides takes some per mille of what is offered.
TEST(SideLedger, SplitsTheCornerOfTwoSides) {
  RichardsProblem problem = four_sides();
  problem.soils[0].saturated_conductivity = 1e-6;
  problem.initial_head.assign(problem.mesh.node_count(), -0.1);
  problem.boundary = {RainSide{"top", {{0}, {1e-3}}}, FluxSide{"left", {{0}, {1e-2}}}};
  const meshes::FieldHistory history = solve(problem);
  for (const char* side : {"top", "left"}) {
    const meshes::SideLedger& ledger = line(history, side);
    EXPECT_NEAR(ledger.run_off.back() / ledger.asked.back(), 1, 0.01) << side;
  }
}

TEST(SideLedger, HasTheSource) {
  RichardsProblem problem = four_sides();
  problem.source = [](const meshes::Point&, double) { return 1e-5; };
  const meshes::FieldHistory history = solve(problem);
  ASSERT_EQ(history.sides.back().condition, "source");
  EXPECT_NEAR(history.sides.back().outflow.back(), -600 * 1e-5 * 1.2, 1e-12);
  EXPECT_LE(worst_imbalance(history), 1e-8);
}

}  // namespace
}  // namespace wetfront::fem_reference
