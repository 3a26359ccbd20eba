#include "mpm/two_velocity/content_table.h"
#include "tests/mpm/continuation.h"
#include "tests/mpm/two_velocity_coupled_scenes.h"

#include <gtest/gtest.h>

/// The two-velocity liquid in bodies that move through cells.
namespace wetfront::mpm::test {
namespace {

TEST(TabulatedContent, InvertsItselfAndFollowsTheClosedLaw) {
  for (const auto& [spec, modulus] : {std::pair{VanGenuchtenRetention{4350, 0.61, 0.087, 1.0}, 0.2e9},
                                      {{4350, 0.61, 0.87, 1.0}, 2.15e9},
                                      {{20000, 0.1, 0.2, 1.0}, 2e9}}) {
    const TabulatedContent table(TabulatedCurve(sampled_retention(spec)), modulus);
    const WaterContent closed(VanGenuchten(spec), modulus);
    for (double p = -1e-3; p > -1e7; p *= 1.07) {
      const double content = table.value(p);
      EXPECT_NEAR(table.value(table.pressure_of(content)) / content, 1, 1e-13) << p;
      EXPECT_NEAR(content / closed.value(p), 1, 1e-8) << p << ": the bound of LogTable for these laws";
    }
    EXPECT_NEAR(table.pressure_of(closed.value(1e5)), 1e5, 1e-3);
    // Wetter, the liquid's own compressibility is no small part of 1 - content; drier, of content - s_min.
    for (double p = -150; p > -2e4; p *= 1.07)
      EXPECT_NEAR(table.slope_near(table.value(p)) / table.slope(p), 1, 1e-2) << p;
  }
}

class CoupledLimit : public testing::TestWithParam<LiquidScheme> {};
/// At the formula itself nothing grows; 1.4 times it the saturated bodies of squares and parallelograms do, whatever
/// the drag.
TEST_P(CoupledLimit, StableBelowAndNotAbove) {
  for (const Body& body : bodies())
    for (const CoupledCondition& condition : coupled_conditions) {
      const Problem<2> problem = coupled_body(body.mesh, condition, GetParam());
      const std::string where = std::string(body.name) + ", " + condition.name;
      const Trial good = run_at(problem, 1, 200);
      EXPECT_EQ(good.stopped, "") << where;
      EXPECT_LT(good.growth, 3) << where;
      if (condition.pressure < 0 || std::string(condition.name) == "stiff skeleton" ||
          std::string(body.name) == "unstructured" || GetParam() == LiquidScheme::explicit_drag)
        continue;  // the skeleton's own limit, or a cell's smallest altitude, leaves more
      EXPECT_GT(run_at(problem, 1.4, 400).growth, 10) << where;
    }
}
/// A surface through cells, down to slivers of a fiftieth: with the steps that runs take. (At the formula itself the
/// sliver's part of the water beats, 20 times the first disturbance in 200 steps and no more in 2400.)
TEST_P(CoupledLimit, HoldsForCellsThatAreHardlyFilled) {
  for (double fill : {0.02, 0.1, 0.3, 0.49, 0.51, 0.7})
    for (const CoupledCondition& condition : coupled_conditions) {
      Problem<2> problem = coupled_body(sheared_box(0), condition, GetParam());
      const double top = 0.03 * (6 + fill);
      problem.surface = {{-1, top, 0}, {1, top, 0}};
      std::erase_if(problem.fixities, [](const Fixity& f) { return f.side == "top"; });
      const Trial trial = run_at(problem, problem.stages[0].step_safety, 200);
      EXPECT_EQ(trial.stopped, "") << fill << ", " << condition.name;
      EXPECT_LT(trial.growth, 4) << fill << ", " << condition.name;
    }
}
INSTANTIATE_TEST_SUITE_P(Drag, CoupledLimit, testing::Values(LiquidScheme::implicit_drag, LiquidScheme::explicit_drag),
                         scheme_of_test);

/// A block of 8 x 8 cells of 2 cm in a wide box, without weight, pressures from -3 to -7 kPa across it, moving at 2 m/s
/// and, sheared, by `shear` times the height.
Problem<2> block(int points_per_cell, double shear) {
  Problem<2> problem = with_two_velocities(seed_column(1, 0.087, 0, 0.25));
  constexpr double h = 0.02;
  problem.mesh = box(0.9, 0.24, 45, 12);
  problem.gravity = {0, 0};
  problem.water_boundary.clear();
  problem.soils[0].elastic = Elastic{10e6, 0.3, "test:elastic"};
  problem.soils[0].intrinsic_permeability = 1e-14;  // what flows in that time is a hundredth of what the test asks
  problem.points_per_cell = points_per_cell;
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(-3e3 - 4e3 * (node[0] / h - 2) / 8);
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c) {
    const std::size_t column = c % 45, row = c / 45;
    problem.empty_cells.push_back(column >= 2 && column < 10 && row >= 2 && row < 10 ? 0 : 1);
  }
  problem.initial_velocity = [shear](const std::array<double, 2>& x) {
    return std::array<double, 2>{2 + shear * x[1], 0};
  };
  problem.output_times = {0.25};
  return problem;
}

struct Drift {
  double water = 0;     ///< |total - total at the start| / total
  double pressure = 0;  ///< of the points' own water, largest change over the range
  double beyond = 0;    ///< of cells beyond the range of the start, over it
  double cells = 0;     ///< through which the block has moved
};

/// Moves the block; points know where they began from where they are.
Drift move(const Problem<2>& problem, double shear) {
  State state = Simulation<2>(problem).state();
  balance_by_effective_stress(problem, state);
  {
    // Each point by its own pressure: no total stress anywhere.
    const auto &water = state.fields.at("point.water"), &volume = state.fields.at("point.volume");
    auto& stress = state.fields.at("point.stress");
    const TabulatedContent law(TabulatedCurve(sampled_retention(*problem.soils[0].retention)), 0.2e9);
    for (std::size_t q = 0; q < water.size(); ++q) {
      const double content = water[q] / (0.46 * volume[q]), p = law.pressure_of(content);
      for (std::size_t k = 0; k < 3; ++k) stress[k * water.size() + q] = law.saturation(content, p) * p;
    }
  }
  const double before =
      std::accumulate(state.fields.at("point.water").begin(), state.fields.at("point.water").end(), 0.);
  Simulation<2> simulation(problem, state);
  while (!simulation.finished()) simulation.step();
  const State end = simulation.state();
  const auto &water = end.fields.at("point.water"), &volume = end.fields.at("point.volume"),
             &mass = end.fields.at("point.mass"), &position = end.fields.at("point.position");
  const TabulatedContent law(TabulatedCurve(sampled_retention(*problem.soils[0].retention)), 0.2e9);
  constexpr double h = 0.02, range = 4e3 * 7 / 8;
  Drift drift;
  const std::size_t points = water.size();
  for (std::size_t q = 0; q < points; ++q) {
    const double x = position[q], y = position[points + q], began = x - (2 + shear * y) * simulation.time();
    const double p = law.pressure_of(water[q] / (volume[q] - mass[q] / 2690));
    // A column began with one pressure; which one is it? Shear shifts points by parts of a column.
    double nearest = 1e9;
    for (double column : {std::floor(began / h - 0.4), std::floor(began / h), std::floor(began / h + 0.4)})
      nearest = std::min(nearest, std::abs(p + 3e3 + 4e3 * (column + 0.5 - 2) / 8));
    drift.pressure = std::max(drift.pressure, nearest / range);
    drift.cells = std::max(drift.cells, (x - began) / h);
  }
  drift.water = std::abs(std::accumulate(water.begin(), water.end(), 0.) / before - 1);
  const auto history = simulation.take_history();
  for (double p : history.snapshots.back().cell_pressure)
    if (!std::isnan(p)) drift.beyond = std::max({drift.beyond, (p + 3250) / range, (-6750 - p) / range});
  return drift;
}

TEST(MovingBody, CarriesItsWaterThroughTwentyCells) {
  for (int points : {1, 4, 9})
    for (double shear : {0.0, 1.0}) {
      if (points == 9 && shear != 0) continue;  // its columns cannot be told apart any more by place
      Problem<2> problem = block(points, shear);
      // Soft in shear, stiff in volume: sheared by inertia alone.
      if (shear != 0) problem.soils[0].law = MohrCoulomb{0, 50, 0, {}, "test:law"};
      const Drift drift = move(problem, shear);
      std::printf("%d points per cell, shear %g: %.0f cells, water %.1e, pressure %.2f %%, beyond %.2f %%\n", points,
                  shear, drift.cells, drift.water, 100 * drift.pressure, 100 * drift.beyond);
      EXPECT_GE(drift.cells, 20);
      EXPECT_LE(drift.water, 1e-10);
      EXPECT_LE(drift.pressure, 0.005);
      EXPECT_LE(drift.beyond, 0.01);
    }
}

/// Both phases together keep their momentum while the block vibrates and its water flows.
TEST(MovingBody, KeepsTheMomentumOfBothPhases) {
  Problem<2> problem = block(4, 0);
  const auto momentum = [](const State& state) {
    const auto &mass = state.fields.at("point.mass"), &water = state.fields.at("point.water"),
               &solid = state.fields.at("point.velocity"), &liquid = state.fields.at("point.liquid velocity");
    std::array<double, 2> sum{};
    for (std::size_t q = 0; q < mass.size(); ++q)
      for (std::size_t a = 0; a < 2; ++a)
        sum[a] += mass[q] * solid[a * mass.size() + q] + 1000 * water[q] * liquid[a * mass.size() + q];
    return sum;
  };
  problem.initial_velocity = [](const std::array<double, 2>& x) {
    return std::array<double, 2>{1 + 0.1 * std::sin(40 * x[0]), 0.1 * x[0]};
  };
  problem.soils[0].intrinsic_permeability = 1e-22;  // water that changes points leaves its momentum behind
  State state = Simulation<2>(problem).state();
  const auto before = momentum(state);
  Simulation<2> simulation(problem, state);
  for (int step = 0; step < 300; ++step) simulation.step();
  const auto after = momentum(simulation.state());
  for (std::size_t a = 0; a < 2; ++a) EXPECT_NEAR(after[a], before[a], 1e-12 * before[0]);  // round-off of 300 steps
}

TEST(MovingBody, CutAndContinueGivesTheSameBitsWhilePointsCrossCells) {
  Problem<2> problem = block(4, 1);
  problem.water_boundary = {RainSide{free_surface, {{0}, {1e-4}}, "test:rain"}};
  problem.gravity = {0, -9.81};
  problem.stages[0].end_time = 0.02;
  problem.output_times = {0.02};
  expect_continuation_at(problem, 0.0111);
}

/// Water as stiff as it is, soil as tight as clay, its weight put on at once: pressures of the cells bear it smoothly,
/// no checkerboard.
TEST(MovingBody, UndrainedBoxHasNoCheckerboard) {
  CoupledCondition condition{"undrained", 0, 1e-16, 10e6, 2.15e9};
  Problem<2> problem = coupled_body(sheared_box(0), condition, LiquidScheme::implicit_drag);
  std::erase_if(problem.fixities, [](const Fixity& f) { return f.side == "top"; });
  problem.initial_pressure.assign(problem.mesh.node_count(), 100.0);
  problem.gravity = {0, -9.81};
  problem.gravity_origin = "test:gravity";
  problem.stages[0].local_damping = 0.3;
  problem.stages[0].end_time = 0.04;
  problem.output_times = {0.04};
  const auto history = run(problem);
  const auto& p = history.snapshots.back().cell_pressure;
  const double total = (0.54 * 2690 + 0.46 * 1000) * 9.81 * 0.24, stiff = 2.15e9 / 0.46,
               share = stiff / (stiff + 10e6 * 0.7 / (1.3 * 0.4));
  for (std::size_t row = 0; row < 8; ++row)
    for (std::size_t column = 0; column < 8; ++column) {
      const double expected = 100 + share * total * (7.5 - static_cast<double>(row)) / 8;
      // Half a cell's weight: nodes carry what lies around them.
      EXPECT_NEAR(p[8 * row + column], expected, 0.03 * total) << row << ", " << column;
      EXPECT_NEAR(p[8 * row + column], p[8 * row], 0.01 * total) << row << ", " << column;
    }
}

}  // namespace
}  // namespace wetfront::mpm::test
