// Soils that meet in one cell: each point stores and conducts water by the law of its own soil, whatever cell it is in,
// and soils that are alike are one soil.
#include "mpm/simulation.h"
#include "tests/mpm/continuation.h"
#include "tests/mpm/small_slope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace wetfront::mpm {
namespace {

using test::layered_slope, test::slope;

/// The laws of van Genuchten and Mualem once more, by hand.
struct ByHand {
  const Soil& soil;
  double effective(double p) const {
    const auto& curve = std::get<VanGenuchtenRetention>(*soil.retention);
    return std::pow(1 + std::pow(std::max(0.0, -p) / curve.air_entry, 1 / (1 - curve.lambda)), -curve.lambda);
  }
  double saturation(double p) const {
    const auto& curve = std::get<VanGenuchtenRetention>(*soil.retention);
    return curve.s_min + (curve.s_max - curve.s_min) * effective(p);
  }
  double mobility(double p) const {
    const double lambda = std::get<VanGenuchtenRetention>(*soil.retention).lambda, se = effective(p);
    const double bracket = 1 - std::pow(1 - std::pow(se, 1 / lambda), lambda);
    return soil.intrinsic_permeability / 1e-3 * std::sqrt(se) * bracket * bracket;
  }
};

Soil other_soil(const Soil& like) {
  Soil soil = like;
  soil.name = "other";
  soil.porosity = 0.38;
  soil.intrinsic_permeability = 0.3 * like.intrinsic_permeability;
  soil.retention = VanGenuchtenRetention{6000, 0.5, 0.1, 0.95};
  return soil;
}

/// One cell over another, the upper one of another soil; one of its points lies in the lower cell.
struct TwoCells {
  Problem<2> problem = test::seed_column(2, 0.087, 0, 1e3);
  State state;
  std::vector<int> soil{0, 0, 0, 0, 1, 1, 1, 1};  ///< of the points, in their order

  explicit TwoCells(const std::array<double, 2>& stray = {0.21, 0.37}, bool drains = false) {
    problem.soils.push_back(other_soil(problem.soils[0]));
    problem.mesh.region = {0, 1};
    problem.mesh.region_names = {"sand", "other"};
    problem.water_boundary.clear();
    if (drains) problem.water_boundary = {FreeDrainageSide{"base", "o"}};
    problem.stages[0].integrator = TimeIntegrator::backward_euler;
    for (std::size_t i = 0; i < 6; ++i) problem.initial_pressure[i] = -3000 - 100.0 * static_cast<double>(i);
    state = Simulation<2>(problem).state();
    state.fields["points per cell"] = {4, 0, 1, 3};  // per soil, then per cell
    state.fields["point.position"][4] = stray[0];
    state.fields["point.position"][8 + 4] = stray[1];
    state.fields["node.stored water"] = stored(state.fields["node.pressure"]);
  }
  double shape(int node, const std::array<double, 2>& x) const {
    const auto& at = problem.mesh.nodes[static_cast<std::size_t>(node)];
    const double h = 0.6;
    return std::max(0.0, 1 - std::abs(x[0] - at[0]) / h) * std::max(0.0, 1 - std::abs(x[1] - at[1]) / h);
  }
  /// d/dx or d/dy of a node of the point's cell.
  double slope(int node, const std::array<double, 2>& x, int axis) const {
    const auto& at = problem.mesh.nodes[static_cast<std::size_t>(node)];
    const double h = 0.6;
    const double across =
        std::max(0.0, 1 - std::abs(x[static_cast<std::size_t>(1 - axis)] - at[static_cast<std::size_t>(1 - axis)]) / h);
    const double away = x[static_cast<std::size_t>(axis)] - at[static_cast<std::size_t>(axis)];
    return std::abs(away) < h ? (away < 0 ? 1 : -1) * across / h : 0;
  }
  std::array<double, 2> place(std::size_t point) const {
    const auto& x = state.fields.at("point.position");
    return {x[point], x[8 + point]};
  }
  /// W_i = sum_p n V N_i S(p_i), every point by its own soil.
  std::vector<double> stored(const std::vector<double>& p) const {
    std::vector<double> water(6, 0.0);
    for (std::size_t q = 0; q < 8; ++q)
      for (int i = 0; i < 6; ++i) {
        const Soil& own = problem.soils[static_cast<std::size_t>(soil[q])];
        water[static_cast<std::size_t>(i)] += own.porosity * state.fields.at("point.volume")[q] * shape(i, place(q)) *
                                              ByHand{own}.saturation(p[static_cast<std::size_t>(i)]);
      }
    return water;
  }
  /// R_i = sum_p V grad N_i . q_p.
  std::vector<double> inflow(const std::vector<double>& p) const {
    std::vector<double> rate(6, 0.0);
    for (std::size_t q = 0; q < 8; ++q) {
      double here = 0;
      std::array<double, 2> drive{0, 9810};
      for (int i = 0; i < 6; ++i) {
        here += shape(i, place(q)) * p[static_cast<std::size_t>(i)];
        for (int a = 0; a < 2; ++a)
          drive[static_cast<std::size_t>(a)] += slope(i, place(q), a) * p[static_cast<std::size_t>(i)];
      }
      const double mobility = ByHand{problem.soils[static_cast<std::size_t>(soil[q])]}.mobility(here);
      for (int i = 0; i < 6; ++i)
        for (int a = 0; a < 2; ++a)
          rate[static_cast<std::size_t>(i)] -= state.fields.at("point.volume")[q] * slope(i, place(q), a) * mobility *
                                               drive[static_cast<std::size_t>(a)];
    }
    return rate;
  }
};

TEST(Layers, ACellOfTwoSoilsStoresAndConductsByTheLawOfEachPoint) {
  const TwoCells cells;
  Simulation<2> simulation(cells.problem, cells.state);
  simulation.step();
  const auto fields = simulation.state().fields;
  const std::vector<double>&p = fields.at("node.pressure"), &water = fields.at("node.stored water");
  const std::vector<double> stored = cells.stored(p), rate = cells.inflow(p);
  const std::vector<double>& before = cells.state.fields.at("node.stored water");
  double most = 0;
  for (const double r : rate) most = std::max(most, std::abs(r));
  for (std::size_t i = 0; i < 6; ++i) {
    // The tables are good to some 1e-8; a step changes S by 1e-4.
    EXPECT_NEAR(water[i], stored[i], 1e-7 * stored[i]) << i;
    EXPECT_NEAR((water[i] - before[i]) / simulation.time(), rate[i], 2e-3 * most) << i;
  }
  // Points, too, hold what their own soil holds at their pressure.
  for (std::size_t q = 0; q < 8; ++q)
    EXPECT_NEAR(
        fields.at("point.saturation")[q],
        ByHand{cells.problem.soils[static_cast<std::size_t>(cells.soil[q])]}.saturation(fields.at("point.pressure")[q]),
        1e-7);
}

/// The point nearest to a piece of the border says what soil is there.
TEST(Layers, ASideDrainsByTheSoilOfTheNearestPoint) {
  for (const auto& [stray, soil] : {std::pair{std::array{0.3, 0.02}, 1u}, {std::array{0.3, 0.5}, 0u}}) {
    const TwoCells cells(stray, true);
    Simulation<2> simulation(cells.problem, cells.state);
    simulation.step();
    const auto fields = simulation.state().fields;
    const auto total = [](const std::vector<double>& values) {
      return std::accumulate(values.begin(), values.end(), 0.0);
    };
    const ByHand law{cells.problem.soils[soil]};
    double drained = 0;
    for (std::size_t i = 0; i < 2; ++i) drained += 0.3 * law.mobility(fields.at("node.pressure")[i]) * 9810;
    const double lost = total(cells.state.fields.at("node.stored water")) - total(fields.at("node.stored water"));
    EXPECT_NEAR(lost / simulation.time(), drained, 2e-3 * drained) << soil;
  }
}

/// A slope too steep and wet to stand, in true time from the start: nothing in it waits for a relaxation to end.
Problem<2> at_once(Problem<2> problem, double until) {
  problem.stages.erase(problem.stages.begin());
  problem.stages[0].ends_with = StageEnd::time;
  problem.stages[0].end_time = until;
  problem.stages[0].longest = 0;
  problem.initial_pressure.assign(problem.mesh.node_count(), -300);
  problem.output_times = {until};
  for (Soil& soil : problem.soils) std::get<MohrCoulomb>(*soil.law).friction = 12 * test::degree;
  return problem;
}

/// Points of soil 0 in cells of soil 1, and the other way round.
std::size_t strangers(const Problem<2>& problem, const State& state) {
  const auto& counts = state.fields.at("points per cell");
  const std::size_t cells = problem.mesh.cell_count();
  double found = 0;
  for (std::size_t soil = 0; soil * cells < counts.size(); ++soil)
    for (std::size_t c = 0; c < cells; ++c)
      if (problem.mesh.region[c] != static_cast<int>(soil)) found += counts[soil * cells + c];
  return static_cast<std::size_t>(found);
}

TEST(Layers, TwoLayersOfOneSoilSlideAsOneLayer) {
  const Problem<2> one = at_once(slope(24, 4), 0.5);
  Soil same = one.soils[0];
  same.name = "the same again";
  const Problem<2> two = at_once(layered_slope(24, 4, same), 0.5);
  Simulation<2> single(one), layered(two);
  while (!single.finished()) single.step();
  while (!layered.finished()) layered.step();
  const State a = single.state(), b = layered.state();
  EXPECT_GT(strangers(two, b), 8u);
  const auto &at = a.body.riders.at(0).place.back(), &there = b.body.riders.at(0).place.back();
  const auto& start = a.body.riders[0].start;
  const double moved = std::hypot(at[0] - start[0], at[1] - start[1]);
  EXPECT_GT(moved, 0.1);
  // Round-off: 4e-14 measured.
  EXPECT_LT(std::hypot(at[0] - there[0], at[1] - there[1]), 1e-9 * moved);
  EXPECT_NEAR(a.history.ledger.back().stored, b.history.ledger.back().stored, 1e-10 * a.history.ledger.back().stored);
  EXPECT_NEAR(a.history.motion.back().kinetic, b.history.motion.back().kinetic, 1e-7 * a.history.motion.back().kinetic);
}

TEST(Layers, DifferentLayersSlideAndLoseNothing) {
  const Problem<2> problem = at_once(layered_slope(24, 4, other_soil(slope(24, 4).soils[0])), 0.5);
  Simulation<2> simulation(problem);
  const std::size_t points = simulation.state().fields.at("point.volume").size();
  while (!simulation.finished()) simulation.step();
  const State state = simulation.state();
  EXPECT_GT(strangers(problem, state), 8u);
  EXPECT_EQ(state.fields.at("point.volume").size(), points);
  const auto &first = state.history.ledger.front(), &last = state.history.ledger.back();
  EXPECT_NEAR(last.stored - first.stored, last.infiltrated - last.outflow, 1e-9 * last.rain_asked);
}

TEST(Layers, DifferentLayersThatSlideContinueWithTheSameBits) {
  const Problem<2> problem = at_once(layered_slope(24, 4, other_soil(slope(24, 4).soils[0])), 0.5);
  for (const double time : {0.1, 0.3, 0.45}) test::expect_continuation_at(problem, time);
}

TEST(Layers, TwoVelocitiesDoNotTakeOverSoilsThatHaveMixed) {
  Problem<2> problem = at_once(layered_slope(24, 4, other_soil(slope(24, 4).soils[0])), 0.3);
  Stage split = problem.stages[0];
  split.name = "two velocities";
  split.liquid = LiquidScheme::implicit_drag;
  split.end_time = 0.31;
  problem.stages.push_back(split);
  Simulation<2> simulation(problem);
  try {
    while (!simulation.finished()) simulation.step();
    FAIL() << "went on";
  } catch (const std::exception& refused) {
    EXPECT_THAT(refused.what(), testing::HasSubstr("have moved into the cells of another before"));
  }
}

}  // namespace
}  // namespace wetfront::mpm
