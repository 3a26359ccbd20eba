// The water boundaries of seepage against closed forms, balances and each other.
#include "mpm/boundary/outlets.h"
#include "mpm/simulation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace wetfront::mpm {
namespace {

constexpr double unit_weight = 9810;

/// Water balance of nodes and of sides: worst error over all rows, relative to the water that passed.
void expect_balance(const meshes::FieldHistory& history) {
  const auto& first = history.ledger.front();
  double passed = 1e-12;
  for (std::size_t k = 0; k < history.ledger.size(); ++k) {
    const auto& row = history.ledger[k];
    passed = std::max(passed, row.rain_asked + std::abs(row.outflow));
    for (const auto& side : history.sides) passed = std::max(passed, std::abs(side.outflow.at(k)));
    EXPECT_NEAR(row.stored - first.stored, row.infiltrated - row.outflow, 1e-8 * passed) << row.time;
    EXPECT_NEAR(row.rain_asked - row.run_off, row.infiltrated, 1e-12 * passed);
    double asked = 0, run_off = 0, out = 0;
    for (const auto& side : history.sides) {
      ASSERT_EQ(side.asked.size(), history.ledger.size());
      asked += side.asked[k];
      run_off += side.run_off[k];
      out += side.outflow[k] + side.evaporated[k];
      EXPECT_LE(side.evaporated[k], side.demanded[k] + 1e-12 * passed);
    }
    EXPECT_NEAR(asked, row.rain_asked, 1e-12 * passed);
    EXPECT_NEAR(run_off, row.run_off, 1e-12 * passed);
    EXPECT_NEAR(out, row.outflow, 1e-12 * passed);
  }
  for (const auto& node : history.rain_by_node)
    EXPECT_NEAR(node.asked - node.run_off, node.imposed, 1e-6 * node.asked + 1e-18);
}

TEST(Sides, EvaporationIsMetInFullUntilTheSoilIsTooDryAndThenInPart) {
  Problem<2> problem = test::seed_column(20, 0.087, 0, 4e5);
  RainSide rain{"top", {{0}, {0}}, "o"};
  rain.evaporation = {{0}, {4e-7}};
  rain.least_pressure = -50e3;
  problem.water_boundary = {rain};
  problem.probes = {{"top", {0.01, 1.2, 0}, "o"}};
  const auto history = run<2>(problem);
  expect_balance(history);
  const auto& side = history.sides.at(0);
  const auto& surface = history.gauges[0].pressure;
  EXPECT_GT(*std::min_element(surface.begin(), surface.end()), -50e3 - 7);  // it fades out over 6 Pa
  bool full = true;
  for (std::size_t k = 1; k < surface.size() && full; ++k) {
    full = surface[k] > -50e3;
    if (full) {
      EXPECT_NEAR(side.evaporated[k], side.demanded[k], 1e-9 * side.demanded[k]);
    }
  }
  EXPECT_FALSE(full);
  EXPECT_LT(side.evaporated.back(), 0.9 * side.demanded.back());
  EXPECT_NEAR(side.demanded.back(), 0.06 * 4e-7 * 4e5, 1e-14);
}

TEST(Sides, AFluxPerAreaBringsAndTakesWhatItSays) {
  Problem<2> problem = test::seed_column(20, 0.087, 0, 2000);
  for (std::size_t i = 1; i < problem.mesh.node_count(); i += 2) problem.mesh.nodes[i][1] += 0.03;  // slope 1:2
  problem.water_boundary = {FluxSide{"top", {{0, 1000}, {2e-5, -2e-6}}, -1.5e6, "o"}};
  const auto history = run<2>(problem);
  expect_balance(history);
  const double area = 0.06 * std::sqrt(1.25);
  EXPECT_NEAR(history.ledger.back().rain_asked, area * 2e-5 * 1000, 1e-14);
  EXPECT_NEAR(history.sides[0].evaporated.back(), area * 2e-6 * 1000, 1e-14);
}

TEST(Sides, HeldPressuresFollowRecordsWithJumpsAndStayInitial) {
  Problem<2> problem = test::seed_column(20, 0.087, 0, 600);
  PressureSide base{"base", 0, "o"};
  base.record = {{0, 200, 200, 400}, {0, 1000, -2000, 3000}};
  problem.water_boundary = {base};
  problem.probes = {{"base", {0.01, 0, 0}, "o"}};
  problem.output_times = {200};
  const auto history = run<2>(problem);
  expect_balance(history);
  for (std::size_t k = 1; k < history.gauges[0].time.size(); ++k) {
    const double t = history.gauges[0].time[k];
    const double wanted = t <= 200 ? 5 * t : t < 400 ? -2000 + 25 * (t - 200) : 3000;
    EXPECT_NEAR(history.gauges[0].pressure[k], wanted, 1e-9) << t;
  }
  std::vector<double> times = history.gauges[0].time;
  for (double wanted : {200.0, 400.0}) EXPECT_THAT(times, ::testing::Contains(wanted));
  base.record = {};
  base.initial = true;
  problem.water_boundary = {base, PressureSide{"top", 0, "o", {}, true}};
  problem.output_times = {600};
  const auto kept = run<2>(problem);
  expect_balance(kept);
  for (std::size_t i : {0u, 1u, 40u, 41u}) EXPECT_EQ(kept.snapshots[0].node_pressure[i], problem.initial_pressure[i]);
}

/// A box of saturated soil between two water bodies.
Problem<2> dam(int n, bool crooked) {
  Problem<2> problem = test::seed_column(1, 0.087, 0, 1);
  problem.mesh = crooked ? test::crooked_box(1, 1, n, n) : test::box(1, 1, n, n);
  problem.initial_pressure.assign(problem.mesh.node_count(), 0);
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
    problem.initial_pressure[i] = unit_weight * (1.5 - problem.mesh.nodes[i][1]);
  return problem;
}

/// After 2000 s the head falls evenly from 2 m on the left to 1.2 m on the right.
meshes::FieldHistory expect_linear_heads(Problem<2> problem) {
  problem.stages[0].end_time = 2000;
  problem.output_times = {2000};
  const auto history = run<2>(problem);
  expect_balance(history);
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) {
    const auto& x = problem.mesh.nodes[i];
    EXPECT_NEAR(history.snapshots[0].node_pressure[i], unit_weight * (2.0 - 0.8 * x[0] - x[1]), 1e-3);
  }
  return history;
}

TEST(Sides, TotalHeadsDriveTheFluxOfDarcysLaw) {
  Problem<2> problem = dam(8, true);
  problem.water_boundary = {TotalHeadSide{"left", {{0}, {2.0}}, "o"},
                            TotalHeadSide{"right", {{0, 500}, {1.5, 1.2}}, "o"}};
  const auto history = expect_linear_heads(problem);
  const auto &a = history.ledger[history.ledger.size() - 2], &b = history.ledger.back();
  const double span = b.time - a.time, flux = 2.943e-4 * 0.8;
  const std::size_t k = history.ledger.size() - 1;
  EXPECT_NEAR((history.sides[0].outflow[k] - history.sides[0].outflow[k - 1]) / span, -flux, 1e-6 * flux);
  EXPECT_NEAR((history.sides[1].outflow[k] - history.sides[1].outflow[k - 1]) / span, flux, 1e-6 * flux);
  EXPECT_EQ(history.sides[0].condition, "head");
}

TEST(Sides, AWaterLevelUnderWhichAllLiesIsATotalHead) {
  Problem<2> problem = dam(8, false);
  problem.water_boundary = {WaterLevelSide{"left", {{0}, {2.0}}, {}, "o"},
                            WaterLevelSide{"right", {{0}, {1.2}}, {}, "o"}};
  expect_linear_heads(problem);
}

TEST(Sides, ALevelThatRisesAndFallsAlongASlopeFillsAndDrainsTheSoil) {
  // A bank with a face of 45 degrees; water rises along it in an hour, stays, and falls.
  Problem<2> problem = test::seed_column(1, 0.087, 0, 1);
  const int n = 12;
  problem.mesh = test::plane(2 * n, n, [](double u, double v) { return meshes::Point{v + u * (3 - v), v, 0}; });
  problem.initial_pressure.clear();
  for (const auto& x : problem.mesh.nodes) problem.initial_pressure.push_back(-unit_weight * x[1]);
  problem.water_boundary = {WaterLevelSide{"left", {{0, 3600, 20000, 23600}, {0, 0.85, 0.85, 0}}, {}, "o"}};
  problem.stages[0].end_time = 40000;
  problem.stages[0].time_tolerance = 1e-4;
  problem.output_times = {3600, 20000, 40000};
  const auto history = run<2>(problem);
  expect_balance(history);
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) {
    const auto& x = problem.mesh.nodes[i];
    if (std::abs(x[0] - x[1]) > 1e-9) continue;
    // On the face: hydrostatic below the level while it stands; never above zero over it.
    if (x[1] <= 0.85)
      EXPECT_NEAR(history.snapshots[0].node_pressure[i], unit_weight * (0.85 - x[1]), 1) << x[1];
    else
      EXPECT_LE(history.snapshots[0].node_pressure[i], 1);
    EXPECT_LE(history.snapshots[2].node_pressure[i], 1) << x[1];
  }
  // At the end of the stand the soil has filled towards the level, and afterwards drains again through the face.
  const auto stored = [&](double t) {
    for (const auto& row : history.ledger)
      if (row.time == t) return row.stored;
    return -1.0;
  };
  EXPECT_GT(stored(20000), stored(3600));
  EXPECT_LT(stored(40000), stored(20000));
  // Passing a node must not cost a crawl: some ten steps per cell at most.
  EXPECT_LT(history.ledger.size(), 2000u);
}

TEST(Sides, HeldPressureWinsOverLevelAndLevelOverRain) {
  Problem<2> problem = dam(4, false);
  for (double& p : problem.initial_pressure) p = -5000;
  RainSide rain{"top", {{0}, {1e-5}}, "o"};
  problem.water_boundary = {rain, WaterLevelSide{"top", {{0, 100}, {0.5, 1.5}}, {}, "o"},
                            PressureSide{"left", -100, "o"}};
  problem.stages[0].end_time = 300;
  problem.output_times = {50, 300};
  const auto history = run<2>(problem);
  expect_balance(history);
  for (const auto& snapshot : history.snapshots) EXPECT_EQ(snapshot.node_pressure[20], -100);  // top left
  EXPECT_LT(history.snapshots[0].node_pressure[22], 0);
  EXPECT_NEAR(history.snapshots[1].node_pressure[22], unit_weight * 0.5, 10);
  // Rain on 7/8 of the top (the node of the held side takes none), until the level passes the top at 50 s.
  EXPECT_NEAR(history.sides[0].asked.back(), 0.875 * 1e-5 * 50, 0.02 * 0.875 * 1e-5 * 50);
}

TEST(Sides, PeriodicSidesMakeASlopingLayerAsAccurateAsALevelOne) {
  // Kinematic similarity: a layer at 30 degrees under vertical rain, sides periodic, depends on the depth normal to it
  // only, as a level column with gravity g cos and rain I cos (both per area of the slope).
  const double angle = std::acos(-1.0) / 6, depth = 0.6;
  const int cells = 20;
  Problem<2> level = test::seed_column(1, 0.087, 0, 3000);
  level.mesh = test::strip(depth, cells);
  level.gravity = {0, -9.81 * std::cos(angle)};
  level.initial_pressure.assign(level.mesh.node_count(), -6000);
  level.water_boundary = {RainSide{"top", {{0}, {5e-5 * std::cos(angle)}}, "o"}};
  level.output_times = {3000};
  Problem<2> slope = level;
  slope.mesh = test::plane(3, cells, [&](double u, double v) {
    const double along = 0.1 * u, normal = depth * v;
    return meshes::Point{along * std::cos(angle) - normal * std::sin(angle),
                         along * std::sin(angle) + normal * std::cos(angle), 0};
  });
  slope.gravity = {0, -9.81};
  slope.initial_pressure.assign(slope.mesh.node_count(), -6000);
  slope.water_boundary = {RainSide{"top", {{0}, {5e-5}}, "o"}, PeriodicSides{"left", "right", "o"}};
  const auto flat = run<2>(level), steep = run<2>(slope);
  expect_balance(steep);
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= 3; ++i)
      EXPECT_NEAR(steep.snapshots[0].node_pressure[static_cast<std::size_t>(4 * j + i)],
                  flat.snapshots[0].node_pressure[static_cast<std::size_t>(2 * j)], 1e-3 * 6000)
          << i << ", " << j;
  EXPECT_NEAR(steep.ledger.back().rain_asked, 0.1 * std::cos(angle) * 5e-5 * 3000, 1e-14);
  slope.water_boundary[1] = PeriodicSides{"left", "top", "o"};
  EXPECT_THROW(run<2>(slope), CannotPlan);
}

TEST(Sides, ALongRecordCostsNoMoreThanItsSteps) {
  // 1e5 rows of which all but a few are dry: the dry ones are one.
  Problem<2> problem = test::seed_column(10, 0.087, 0, 1e5);
  meshes::RainRecord rain;
  for (int i = 0; i < 100000; ++i) {
    rain.start.push_back(i);
    rain.intensity.push_back(i % 20000 < 100 ? 1e-5 : 0);
  }
  problem.water_boundary = {RainSide{"top", rain, "o"}, PressureSide{"base", 0, "o"}};
  const auto history = run<2>(problem);
  expect_balance(history);
  EXPECT_NEAR(history.ledger.back().rain_asked, 0.12 * 1e-5 * 500, 1e-14);
  EXPECT_LT(history.ledger.size(), 2000u);
  EXPECT_LT(history.cpu_seconds, 2.0);
}

void expect_refusal(const Problem<2>& problem, const std::string& words) {
  try {
    Simulation<2> simulation(problem);
    FAIL() << "must be refused: " << words;
  } catch (const CannotPlan& refused) {
    EXPECT_THAT(refused.what(), ::testing::HasSubstr(words));
  }
}

/// Half a dam's height of soil with a hole through it whose floor, a side, lies under a roof of soil.
Problem<2> slotted() {
  Problem<2> slot = dam(8, false);
  meshes::Side floor{"floor", {}};
  std::vector<int> cells, region;
  for (std::size_t c = 0; c < slot.mesh.cell_count(); ++c) {
    const auto x = slot.mesh.cell_centre(c);
    if (std::abs(x[0] - 0.5) < 0.2 && std::abs(x[1] - 0.5) < 0.2) continue;
    for (int node : slot.mesh.cell(c)) cells.push_back(node);
    region.push_back(0);
  }
  for (int i = 3; i < 5; ++i)
    for (int node : {i + 9 * 2, i + 1 + 9 * 2}) floor.faces.push_back(node);
  slot.mesh.cells = cells;
  slot.mesh.region = region;
  slot.mesh.sides.push_back(floor);
  return slot;
}

TEST(Sides, RainThatCannotFallStopsTheRun) {
  Problem<2> problem = dam(8, false);
  const auto rain = [](const std::string& side) { return RainSide{side, {{0}, {1e-5}}, "scene:7"}; };
  for (const char* side : {"left", "right", "base"}) {
    problem.water_boundary = {rain(side)};
    expect_refusal(problem, "vertical or faces downwards");
  }
  problem.water_boundary = {rain("nowhere")};
  expect_refusal(problem, "which the mesh does not have");
  problem.water_boundary = {rain(free_surface)};
  expect_refusal(problem, "fills the mesh to its border");
  problem.surface = {{0, 0.55, 0}, {1, 0.55, 0}};
  problem.water_boundary = {rain("top")};
  expect_refusal(problem, "no cell behind that side holds a material point");
  problem.surface = {{0, 0.55, 0}, {0.5, 0.55, 0}, {0.5, 1, 0}, {1, 1, 0}};
  problem.water_boundary = {rain("top")};
  expect_refusal(problem, "Name mpm::free_surface too");
  problem.water_boundary = {rain(free_surface)};
  expect_refusal(problem, "touches the border of the mesh from below");
  problem.water_boundary = {rain("top"), rain(free_surface)};
  Simulation<2> both(problem);
  problem.surface = {{0, -0.55, 0}, {1, -0.55, 0}};
  expect_refusal(problem, "leaves no soil");
  problem.surface.clear();
  Problem<2> slot = slotted();
  slot.water_boundary = {rain("floor")};
  expect_refusal(slot, "soil lies above it");
}

/// Where a body that has moved lies above itself the rain falls on what is on top.
TEST(Sides, SoilUnderSoilLiesInTheShade) {
  const Problem<2> slot = slotted();
  Fields<2> fields(slot);
  StagePlan<2> plan(slot, 0, fields);
  Surface<2> surface(fields.grid, fields.points, slot.mesh);
  surface.update();
  double open = 0, shaded = 0;
  auto all = outlets<2>(plan, surface, "floor", "rain", "o");
  for (const auto& more : outlets<2>(plan, surface, "top", "rain", "o")) all.push_back(more);
  for (const auto& outlet : all) {
    open += outlet.open;
    shaded += outlet.shaded;
  }
  EXPECT_NEAR(open, 1, 1e-12);
  EXPECT_NEAR(shaded, 0.25, 1e-12);
  EXPECT_THROW(check_rain<2>(plan, surface, all, "top", false, "o"), CannotPlan);
  EXPECT_NO_THROW(check_rain<2>(plan, surface, all, "top", true, "o"));
}

TEST(Sides, ALevelNeedsARecord) {
  Problem<2> problem = dam(4, false);
  problem.water_boundary = {TotalHeadSide{"left", {}, "o"}};
  expect_refusal(problem, "without a record");
  problem.water_boundary = {WaterLevelSide{"left", {}, {}, "o"}};
  expect_refusal(problem, "without a record");
}

}  // namespace
}  // namespace wetfront::mpm
