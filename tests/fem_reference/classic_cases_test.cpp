// Classic cases with sharp fronts: gates R3, R4, R8 of benchmarks.md section 0, soils and numbers of its sections 1
// and 2.1. Heights are above the base; the printed depths are below the top.
#include "tests/fem_reference/columns.h"
#include "verification/exact/broadbridge_white.h"
#include "verification/exact/srivastava_yeh_two_layer.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;
namespace exact = verification::exact;

double head_at_depth(const meshes::FieldHistory& history, std::size_t snapshot, double depth) {
  const auto& nodes = history.mesh.nodes;
  const double height = nodes.back()[0];
  const auto node = static_cast<std::size_t>(std::lround((height - depth) / height * (nodes.size() - 1)));
  return history.snapshots[snapshot].node_pressure[node] / unit_weight;
}

RichardsProblem column(int cells, double height, double initial_head, double end_time) {
  RichardsProblem problem;
  problem.mesh = line_mesh(cells, height);
  problem.gravity_direction = {-1, 0, 0};
  problem.unit_weight = unit_weight;
  problem.initial_head.assign(cells + 1, initial_head);
  problem.end_time = end_time;
  problem.output_times = {end_time};
  return problem;
}

struct DepthHead {
  double depth, head;  // cm
};

// Celia et al. 1990, Haverkamp sand, 360 s. R8: 0.5 cm of head behind the front; at the front (14 to 18 cm, up to 13 cm
// of head per cm of depth) the front may be off by 0.5 cm. 2 mm cells: the table is converged, so the mesh must be.
TEST(GateR8, CeliaSand) {
  RichardsProblem problem = column(200, 0.40, -0.615, 360);
  problem.soils = {{"sand", HaverkampRetention{0.075, 0.287, 1.611e6 * std::pow(0.01, 3.96), 3.96},
                    HaverkampConductivity{1.175e6 * std::pow(0.01, 4.74), 4.74}, 9.44e-5, 0, 0}};
  problem.boundary = {HeadSide{"top", -0.207}, HeadSide{"base", -0.615}};
  const meshes::FieldHistory history = solve(problem);
  EXPECT_LE(worst_imbalance(history), 1e-8);
  const DepthHead printed[] = {{2, -21.0794}, {6, -22.3471}, {10, -25.0757}, {12, -27.8025}, {14, -32.8726},
                               {16, -43.044}, {18, -55.985}, {20, -60.803},  {22, -61.439}};
  double worst = 0;
  for (const auto& [depth, head] : printed) {
    const double ours = 100 * head_at_depth(history, 0, 0.01 * depth);
    worst = std::max(worst, std::abs(ours - head));
    EXPECT_NEAR(ours, head, 0.5) << depth;
  }
  // The printed inflow counts from t = 0; ours too, with the jump of the top node's head in the ledger.
  const double inflow = -100 * history.counters.at("outflow through top");
  std::printf("  Celia sand: worst head %.3f cm, inflow %.4f cm (2.3811)\n", worst, inflow);
  EXPECT_NEAR(inflow, 2.3811, 0.001 * 2.3811);
}

// Celia et al. 1990, New Mexico soil. Behind the front 0.5 cm of head; the node in the front (54 and 56 cm at 24 h,
// where N = 800 and 400 of the table itself differ by 5 cm) by the front's place: 0.5 cm, that is half the difference
// of the neighbours' heads per cm. Infiltration within 0.1 %.
TEST(GateR8, NewMexico) {
  constexpr double hour = 3600;
  RichardsProblem problem = column(400, 1.0, -10, 24 * hour);
  problem.output_times = {6 * hour, 12 * hour, 24 * hour};
  problem.soils = {{"New Mexico", VanGenuchten{0.102, 0.368, 3.35, 2}, MualemConductivity{}, 9.22e-5, 0, 0}};
  problem.boundary = {HeadSide{"top", -0.75}, HeadSide{"base", -10}};
  const meshes::FieldHistory history = solve(problem);
  EXPECT_LE(worst_imbalance(history), 1e-8);
  const DepthHead behind[3][8] = {{{10, -85.9777}, {20, -126.0072}},
                                  {{10, -79.9318}, {20, -90.8202}, {25, -101.8094}, {30, -123.3795}},
                                  {{10, -76.8714},
                                   {20, -80.2799},
                                   {25, -82.9675},
                                   {30, -86.7268},
                                   {35, -92.1617},
                                   {40, -100.4566},
                                   {46, -118.3833},
                                   {50, -142.8776}}};
  double worst = 0;
  for (std::size_t s = 0; s < 3; ++s) {
    for (const auto& [depth, head] : behind[s]) {
      if (depth == 0) continue;
      worst = std::max(worst, std::abs(100 * head_at_depth(history, s, 0.01 * depth) - head));
    }
  }
  EXPECT_LE(worst, 0.5);
  // The front passes -358.91 cm at 56 cm: it must do so between 55.5 and 56.5 cm here.
  EXPECT_GT(100 * head_at_depth(history, 2, 0.555), -358.91);
  EXPECT_LT(100 * head_at_depth(history, 2, 0.565), -358.91);
  const double inflow = -100 * history.counters.at("outflow through top");
  std::printf("  New Mexico: worst head behind the front %.3f cm, at 56 cm %.1f cm (-358.9), inflow %.4f cm (4.1138)\n",
              worst, 100 * head_at_depth(history, 2, 0.56), inflow);
  EXPECT_NEAR(inflow, 4.1138, 0.001 * 4.1138);
}

/// Broadbridge & White with lambda = 1 m, dtheta = 0.3, Ks = 1e-4 m/s, so that t = t_dimensionless * 3000 s. Their
/// soil starts at Theta = 0, psi = -infinity; ours at Theta = 1e-3, which is a thousandth of the gate's own scale.
RichardsProblem broadbridge(int cells, double depth, double flux, double end) {
  RichardsProblem problem = column(cells, depth, -1000, end * 3000);
  problem.soils = {{"B&W", BroadbridgeWhiteRetention{0.1, 0.4, 1.5, 1.0}, BroadbridgeWhiteConductivity{}, 1e-4, 0, 0}};
  problem.boundary = {RainSide{"top", {{0}, {flux * 1e-4}}}};
  return problem;
}

TEST(GateR4, SurfaceSaturation) {
  RichardsProblem problem = broadbridge(400, 8, 0.5, 4);
  problem.output_times = {0.1 * 3000, 0.5 * 3000, 3000, 6000, 12000};
  const exact::BroadbridgeWhite solution(1.5, 0.5);
  const meshes::FieldHistory history = solve(problem);
  EXPECT_LE(worst_imbalance(history), 1e-8);
  double worst = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    const double theta = 0.4 * snapshot.node_saturation.back();
    worst = std::max(worst, std::abs((theta - 0.1) / 0.3 - solution.surface_saturation(snapshot.time / 3000)));
  }
  std::printf("  R4 surface: worst |Theta| error %.2e\n", worst);
  EXPECT_LE(worst, 1e-3);
}

TEST(GateR4, TimeToPonding) {
  const meshes::FieldHistory history = solve(broadbridge(400, 3, 2.0, 0.5));
  const double printed = exact::BroadbridgeWhite(1.5, 2.0).time_to_ponding();
  EXPECT_NEAR(printed, 0.3259772425, 1e-9);
  double ponding = 0;
  for (const meshes::LedgerRow& row : history.ledger) {
    if (row.run_off == 0) ponding = row.time / 3000;
  }
  std::printf("  R4 ponding: %.6f (%.6f)\n", ponding, printed);
  EXPECT_NEAR(ponding, printed, 0.005 * printed);
  EXPECT_LE(worst_imbalance(history), 1e-8);
}

/// Relative L2(psi), worst of three times.
double two_layer_error(int cells, double lower, double upper, double before, double after) {
  constexpr double hour = 3600, cm_per_hour = 0.01 / 3600;
  const exact::SrivastavaYehTwoLayerSolution solution({10,
                                                       {lower * cm_per_hour, 0.06, 0.4, 1.0},
                                                       {upper * cm_per_hour, 0.06, 0.4, 1.0},
                                                       before * cm_per_hour,
                                                       after * cm_per_hour,
                                                       0});
  const double unit = hour / after;  // what the rain needs, scaled
  RichardsProblem problem = column(cells, 2, 0, 100 * unit);
  problem.tolerance = 1e-7;
  problem.output_times = {10 * unit, 30 * unit, 100 * unit};
  problem.mesh.region_names = {"lower", "upper"};
  for (int c = cells / 2; c < cells; ++c) problem.mesh.region[c] = 1;
  for (double k : {lower, upper}) {
    problem.soils.push_back(
        {"layer", ExponentialRetention{0.06, 0.4, 10}, ExponentialConductivity{10}, k * cm_per_hour, 0, 0});
  }
  for (int i = 0; i <= cells; ++i) problem.initial_head[i] = solution.head(problem.mesh.nodes[i][0] - 1, 0);
  problem.boundary = {RainSide{"top", {{0}, {after * cm_per_hour}}}, HeadSide{"base", 0}};
  const meshes::FieldHistory history = solve(problem);
  EXPECT_LE(worst_imbalance(history), 1e-8);
  double worst = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    double error = 0, norm = 0;
    for (int i = 0; i <= cells; ++i) {
      const double head = solution.head(problem.mesh.nodes[i][0] - 1, snapshot.time);
      error += std::pow(snapshot.node_pressure[i] / unit_weight - head, 2);
      norm += head * head;
    }
    worst = std::max(worst, std::sqrt(error / norm));
  }
  return worst;
}

void expect_layers(double lower, double upper, double before, double after) {
  const double e100 = two_layer_error(100, lower, upper, before, after);
  const double e200 = two_layer_error(200, lower, upper, before, after);
  std::printf("  R3 Ks %g / %g cm/h: rel-L2(psi) %.2e %.2e, order %.3f\n", lower, upper, e100, e200,
              std::log2(e100 / e200));
  EXPECT_LE(e200, 1e-3);
  EXPECT_GE(std::log2(e100 / e200), 1.9);
}

TEST(GateR3, CoarseBelowFine) {
  expect_layers(10, 1, 0.1, 0.9);
}
TEST(GateR3, FineBelowCoarse) {
  expect_layers(1, 10, 0.1, 0.9);
}
TEST(GateR3, ContrastOfAThousand) {
  expect_layers(0.9, 900, 0.1, 0.8);
}

}  // namespace
}  // namespace wetfront::fem_reference
