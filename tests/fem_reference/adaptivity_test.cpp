#include "tests/fem_reference/adapted.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

/// A unit square, wetted through the left quarter of its top ("strip"; "top" is the rest).
RichardsProblem wetted_square(int cells) {
  RichardsProblem problem;
  problem.mesh = strip_mesh(cells, 1, cells);
  meshes::Side& top = problem.mesh.sides[1];
  const std::vector<int> faces = std::exchange(top.faces, {});
  problem.mesh.sides.push_back({"strip", {}});
  for (int i = 0; i < cells; ++i) {
    std::vector<int>& side = 4 * i < cells ? problem.mesh.sides.back().faces : problem.mesh.sides[1].faces;
    side.insert(side.end(), faces.begin() + 2 * i, faces.begin() + 2 * i + 2);
  }
  problem.gravity_direction = {0, -1, 0};
  problem.soils = {seed_sand(0.087)};
  problem.boundary = {RainSide{"strip", {{0, 200}, {1.2e-3, 1e-4}}}, FreeDrainageSide{"base"}};
  problem.initial_head.assign(problem.mesh.node_count(), -1.0);
  problem.end_time = 400;
  problem.output_times = {100, 400};
  problem.gauges = {{"gauge", {0.07, 0.93, 0}}};
  problem.tolerance = 1e-5;
  return problem;
}

double counter(const meshes::FieldHistory& history, const std::string& name) {
  return history.counters.at(name);
}

/// Root mean square over the nodes of `coarse`, which are nodes of `fine` too, at the last output time.
double difference(const meshes::FieldHistory& coarse, const meshes::FieldHistory& fine, bool saturation) {
  std::map<std::array<long, 3>, std::size_t> node;
  const auto key = [](const meshes::Point& p) {
    return std::array<long, 3>{std::lround(p[0] * 1e7), std::lround(p[1] * 1e7), std::lround(p[2] * 1e7)};
  };
  for (std::size_t i = 0; i < fine.mesh.node_count(); ++i) node[key(fine.mesh.nodes[i])] = i;
  const auto& a = saturation ? coarse.snapshots.back().node_saturation : coarse.snapshots.back().node_pressure;
  const auto& b = saturation ? fine.snapshots.back().node_saturation : fine.snapshots.back().node_pressure;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(a[i] - b[node.at(key(coarse.mesh.nodes[i]))], 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// A threshold of 0 halves everything as often as allowed, at once: the same mesh, so the same steps but for rounding.
TEST(Adaptivity, IsTheUniformMeshWhereTheThresholdIsZero) {
  RichardsProblem coarse = wetted_square(4);
  coarse.adaptivity = Adaptivity{2, 0};
  const meshes::FieldHistory adaptive = solve(coarse), uniform = solve(wetted_square(16));
  EXPECT_EQ(counter(adaptive, "degrees of freedom"), 17 * 17);
  EXPECT_EQ(counter(adaptive, "adapts"), 0);
  EXPECT_NEAR(counter(adaptive, "steps"), counter(uniform, "steps"), 0.05 * counter(uniform, "steps"));
  EXPECT_LT(difference(adaptive, uniform, false), 1e-5 * unit_weight);  // the time error at 1e-5
  EXPECT_LT(difference(adaptive, uniform, true), 1e-5);
  EXPECT_NEAR(adaptive.ledger.back().run_off, uniform.ledger.back().run_off, 1e-7);
  EXPECT_NEAR(adaptive.gauges[0].saturation.back(), uniform.gauges[0].saturation.back(), 1e-5);
}

TEST(Adaptivity, KeepsTheLedgerAndTheRecord) {
  RichardsProblem problem = wetted_square(8);
  problem.adaptivity = Adaptivity{2, 3e-3};
  const meshes::FieldHistory history = solve(problem);
  EXPECT_GE(counter(history, "adapts"), 5);
  EXPECT_EQ(history.mesh.node_count(), 33U * 33U);
  ASSERT_EQ(history.snapshots.size(), 2U);
  EXPECT_EQ(history.snapshots[1].node_pressure.size(), 33U * 33U);
  EXPECT_EQ(history.snapshots[1].cell_saturation.size(), 32U * 32U);
  EXPECT_EQ(history.gauges[0].time.size(), history.ledger.size());
  EXPECT_LE(worst_imbalance(history), 1e-8);
  const meshes::LedgerRow& end = history.ledger.back();
  EXPECT_GT(end.run_off, 0.01 * end.rain_asked);  // it ponds for a while
  EXPECT_NEAR(end.rain_asked, 0.25 * 200 * (1.2e-3 + 1e-4), 1e-13);
  double asked = 0, run_off = 0, outflow = 0;
  for (const meshes::NodeRain& node : history.rain_by_node) {
    asked += node.asked;
    run_off += node.run_off;
    EXPECT_LE(node.position[0], 0.25 + 1e-12);
  }
  EXPECT_EQ(history.rain_by_node.size(), 9U);
  EXPECT_NEAR(asked, end.rain_asked, 1e-13);
  EXPECT_NEAR(run_off, end.run_off, 1e-13);
  for (const meshes::SideLedger& side : history.sides) outflow += side.outflow.back();
  EXPECT_NEAR(outflow, end.outflow, 1e-14);
  EXPECT_EQ(history.sides.back().condition, "adapting the mesh");
  EXPECT_NEAR(history.sides.back().outflow.back(), 0, 1e-12);
  EXPECT_GT(counter(history, "water moved by adapting"), 0);
  EXPECT_LT(counter(history, "water lost by adapting"), 1e-12);
}

/// A sharp front: Celia's New Mexico soil at -10 m, the strip held at -0.75 m, 3 h.
RichardsProblem dry_square(int cells) {
  RichardsProblem problem = wetted_square(cells);
  for (meshes::Point& p : problem.mesh.nodes) p = {0.6 * p[0], 0.6 * p[1], 0};
  problem.soils = {{"loam", VanGenuchten{0.102, 0.368, 3.35, 2.0}, MualemConductivity{}, 9.22e-5}};
  problem.boundary = {HeadSide{"strip", -0.75}};
  problem.initial_head.assign(problem.mesh.node_count(), -10.0);
  problem.end_time = 3 * 3600;
  problem.output_times = {problem.end_time};
  problem.gauges.clear();
  return problem;
}

// As good as the uniform mesh of the smallest cells, against a mesh of half of those: within 20 % with a quarter of the
// unknowns (issue 3).
TEST(Adaptivity, IsAsGoodAsTheFineMesh) {
  const meshes::FieldHistory yardstick = solve(dry_square(64)), uniform = solve(dry_square(32));
  RichardsProblem problem = dry_square(8);
  problem.adaptivity = Adaptivity{2, 3e-3};
  const meshes::FieldHistory adaptive = solve(problem);
  for (const bool saturation : {true, false}) {
    const double fine = difference(uniform, yardstick, saturation), mine = difference(adaptive, yardstick, saturation);
    std::printf("  strip: %s off by %.3e, uniform %.3e\n", saturation ? "S" : "p [Pa]", mine, fine);
    EXPECT_LT(mine, 1.2 * fine);
  }
  const double part = counter(adaptive, "degrees of freedom, mean over steps") / counter(uniform, "degrees of freedom");
  std::printf("  strip: %.3f of the unknowns, %.2f of %.2f CPU s, %.0f adapts\n", part, adaptive.cpu_seconds,
              uniform.cpu_seconds, counter(adaptive, "adapts"));
  EXPECT_LT(part, 0.25);
  EXPECT_LE(worst_imbalance(adaptive), 1e-8);
}

// Every node of the record holds the field of the run's own element: saturation belongs to pressure by the soil's law,
// and where the mesh is coarse the pressure is linear along an edge.
TEST(Adaptivity, RecordsTheElementsOwnField) {
  RichardsProblem problem = wetted_square(4);
  problem.adaptivity = Adaptivity{2, 1};  // nothing is ever halved
  const meshes::FieldHistory history = solve(problem);
  EXPECT_EQ(counter(history, "degrees of freedom"), 25);
  problem.adaptivity.reset();
  const meshes::FieldHistory plain = solve(problem);
  const SoilLaw law(problem.soils[0], unit_weight);
  const meshes::Snapshot &fine = history.snapshots[1], &coarse = plain.snapshots[1];
  for (std::size_t i = 0; i < plain.mesh.node_count(); ++i) {
    EXPECT_NEAR(fine.node_pressure[i], coarse.node_pressure[i], 1e-9);
  }
  for (std::size_t i = 0; i < history.mesh.node_count(); ++i) {
    EXPECT_NEAR(fine.node_saturation[i], law.saturation(fine.node_pressure[i] / unit_weight), 1e-14);
    const meshes::Point& p = history.mesh.nodes[i];
    const double x = std::min(3.0, std::floor(4 * p[0])), y = std::min(3.0, std::floor(4 * p[1]));
    const double u = 4 * p[0] - x, v = 4 * p[1] - y;
    const auto at = [&](double dx, double dy) { return coarse.node_pressure[static_cast<int>(x + dx + 5 * (y + dy))]; };
    const double bilinear = (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
    EXPECT_NEAR(fine.node_pressure[i], bilinear, 1e-9);
  }
}

// One dimension costs little anyway, but works the same.
TEST(Adaptivity, FollowsAFrontInAColumn) {
  RichardsProblem problem = seed_column(30, 0.087, 1.5e-4, 400);
  problem.adaptivity = Adaptivity{2, 2e-2};
  problem.output_times = {400};
  const meshes::FieldHistory adaptive = solve(problem), uniform = solve([] {
                                                          RichardsProblem fine = seed_column(120, 0.087, 1.5e-4, 400);
                                                          fine.output_times = {400};
                                                          return fine;
                                                        }());
  EXPECT_LT(counter(adaptive, "degrees of freedom, mean over steps"), 80);
  std::printf("  column: %.0f of %.0f unknowns, S off by %.1e\n",
              counter(adaptive, "degrees of freedom, mean over steps"), counter(uniform, "degrees of freedom"),
              difference(adaptive, uniform, true));
  EXPECT_LT(difference(adaptive, uniform, true), 5e-3);  // the threshold as a saturation is 4.3e-2
  EXPECT_LE(worst_imbalance(adaptive), 1e-8);
}

RichardsProblem wetted_block(int cells) {
  RichardsProblem problem;
  problem.mesh = block_mesh(cells);
  problem.gravity_direction = {0, 0, -1};
  problem.soils = {seed_sand(0.087)};
  problem.boundary = {RainSide{"patch", {{0}, {2e-4}}}};
  problem.initial_head.assign(problem.mesh.node_count(), -1.0);
  problem.end_time = 200;
  problem.output_times = {200};
  problem.tolerance = 1e-4;
  return problem;
}

TEST(Adaptivity, FollowsAFrontInABlock) {
  RichardsProblem problem = wetted_block(4);
  problem.adaptivity = Adaptivity{1, 1e-2};
  const meshes::FieldHistory adaptive = solve(problem), uniform = solve(wetted_block(8)),
                             coarse = solve(wetted_block(4));
  const double error = difference(adaptive, uniform, true);
  std::printf("  block: %.0f of %.0f unknowns, %.2f of %.2f CPU s, S off by %.1e (coarse mesh %.1e)\n",
              counter(adaptive, "degrees of freedom, mean over steps"), counter(uniform, "degrees of freedom"),
              adaptive.cpu_seconds, uniform.cpu_seconds, error, difference(coarse, uniform, true));
  EXPECT_LT(counter(adaptive, "degrees of freedom, mean over steps"), 0.5 * counter(uniform, "degrees of freedom"));
  EXPECT_LT(error, 0.3 * difference(coarse, uniform, true));
  EXPECT_LE(worst_imbalance(adaptive), 1e-8);
  EXPECT_LT(counter(adaptive, "water lost by adapting"), 1e-12);
}

TEST(Adaptivity, IsRefusedWhereItMakesNoSense) {
  const auto message = [](RichardsProblem problem) -> std::string {
    try {
      solve(problem);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  RichardsProblem problem = wetted_square(4);
  problem.adaptivity = Adaptivity{2, 1e-3};
  problem.degree = 2;
  EXPECT_THAT(message(problem), ::testing::HasSubstr("adaptivity"));
  problem.degree = 1;
  problem.boundary.push_back(PeriodicSides{"left", "right"});
  EXPECT_THAT(message(problem), ::testing::HasSubstr("periodic"));
  problem.boundary.pop_back();
  problem.adaptivity->levels = 20;
  EXPECT_THAT(message(problem), ::testing::HasSubstr("adaptivity.levels"));
  problem.adaptivity = Adaptivity{2, -1};
  EXPECT_THAT(message(problem), ::testing::HasSubstr("adaptivity.threshold"));
}

}  // namespace
}  // namespace wetfront::fem_reference
