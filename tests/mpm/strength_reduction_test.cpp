// Factors of safety by strength reduction, against closed forms of infinite slopes.
#include "mpm/coupling/strength_reduction.h"
#include "tests/mpm/continuation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"
#include "verification/exact/infinite_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wetfront::mpm {
namespace {

namespace exact = verification::exact;

constexpr double degree = std::numbers::pi / 180, height = 1;
constexpr double dry_weight = (1 - 0.46) * 2690 * 9.81, wet_weight = dry_weight + 0.46 * 1000 * 9.81;  // N/m3
/// Of the last bracket.
constexpr SafetySearch search{0.004, 4};

/// A layer of 1 m across a slope, in axes along and across it, dry; its sides are tied: an infinite slope.
Problem<2> layer(int over, double slope, const MohrCoulomb& strength) {
  Problem<2> problem;
  problem.mesh = test::box(height / 2, height, over / 2, over);
  problem.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope)};
  problem.gravity_origin = "o";
  Soil soil = test::seed_sand(0.087);
  soil.retention.reset();
  soil.permeability.reset();
  soil.elastic = Elastic{10e6, 0.3, "o"};
  soil.law = strength;
  problem.soils = {soil};
  problem.fixities = {{"base", {true, true, false}, "o"}};
  problem.skeleton_boundary = {PeriodicSkeleton{"left", "right", "o"}};
  Stage rest;
  rest.name = "rest";
  rest.end_time = 1;
  rest.motion = SkeletonMotion::quasi_static;
  rest.relaxation.most_iterations = 200000;  // times cells over 100
  rest.relaxation.unbalanced_ratio = 1e-5;
  problem.stages = {rest};
  return problem;
}

/// Full of water that flows along the slope: pressure falls to 0 at the surface.
Problem<2> wet_layer(int over, double slope, const MohrCoulomb& strength) {
  Problem<2> problem = layer(over, slope, strength);
  problem.water = test::seed_water();
  const Soil wet = test::seed_sand(0.087);
  problem.soils[0].retention = wet.retention;
  problem.soils[0].permeability = wet.permeability;
  for (const auto& node : problem.mesh.nodes)
    problem.initial_pressure.push_back(9810 * std::cos(slope) * (height - node[1]));
  problem.water_boundary = {PeriodicSides{"left", "right", "o"}, PressureSide{"top", 0, "o"}};
  problem.stages[0].liquid = LiquidScheme::seepage;
  return problem;
}

/// The middle of the last bracket, of the state at the end.
double factor_at_end(const Problem<2>& problem) {
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  const SafetyFactor found = factor_of_safety(problem, simulation.state(), search);
  EXPECT_GT(found.fails, found.stands);
  EXPECT_LE(found.fails - found.stands, search.tolerance);
  return 0.5 * (found.stands + found.fails);
}

/// At a depth across the slope, the pressure as high as the load of water allows where it is wet.
exact::PlaneLoad load(double unit_weight, double slope, double depth, double pore) {
  return {unit_weight * depth * std::cos(slope), unit_weight * depth * std::sin(slope), pore};
}

MohrCoulomb strength(double friction, double cohesion, double dilatancy) {
  return {friction * degree, cohesion, dilatancy * degree, {}, "o"};
}

/// Without cohesion all depths fail at once: the mesh does not matter. 1 %: half a bracket, .2 %, and the 2 cm by which
/// failure is told (measured .8 % with psi = 0, .1 % with psi = phi).
TEST(StrengthReduction, ADryLayerFailsAsDavisHasIt) {
  const double slope = 25 * degree;
  for (const double dilatancy : {0.0, 34.0})
    for (const int over : {4, 8}) {
      const double exact =
          exact::reduced_safety(load(dry_weight, slope, height, 0), {34 * degree, dilatancy * degree, 0});
      EXPECT_NEAR(factor_at_end(layer(over, slope, strength(34, 0, dilatancy))), exact, 0.01 * exact)
          << dilatancy << " " << over;
    }
}

/// Exact for psi = phi. With psi = 0 there are weaker ways to fail than along the slope, the more the finer the mesh
/// (measured 1.0 and 2.1 % at 4 and 8 cells, of which neither the limit of displacement nor that of balance takes more
/// than .6 %): collapse loads of soils that do not flow as they yield are not unique.
TEST(StrengthReduction, AFullLayerFailsByItsEffectiveStress) {
  const double slope = 15 * degree;
  for (const double dilatancy : {0.0, 40.0})
    for (const int over : {4, 8}) {
      const double exact = exact::reduced_safety(load(wet_weight, slope, height, 9810 * height * std::cos(slope)),
                                                 {40 * degree, dilatancy * degree, 0});
      EXPECT_NEAR(factor_at_end(wet_layer(over, slope, strength(40, 0, dilatancy))), exact,
                  (dilatancy > 0 ? 0.01 : 0.025) * exact)
          << dilatancy << " " << over;
    }
}

/// With cohesion the deepest plane is the weakest, and a mesh knows stress at the middle of its deepest cells: first
/// order (measured 4.8 and 2.4 % at 4 and 8 cells, .3 % of what the middle of the deepest cell bears).
TEST(StrengthReduction, ALayerWithCohesionConvergesWithTheMesh) {
  const double slope = 25 * degree;
  const exact::PlaneStrength soil{20 * degree, 0, 2000};
  const double exact = exact::reduced_safety(load(dry_weight, slope, height, 0), soil);
  std::vector<double> error;
  for (const int over : {4, 8}) {
    const double found = factor_at_end(layer(over, slope, strength(20, 2000, 0)));
    const double middle = exact::reduced_safety(load(dry_weight, slope, height * (1 - 0.5 / over), 0), soil);
    EXPECT_NEAR(found, middle, 0.01 * middle) << over;
    error.push_back(found - exact);
  }
  EXPECT_NEAR(error[1] / error[0], 0.5, 0.15);
}

/// Suction holds a slope that would not stand without it.
TEST(StrengthReduction, SuctionIsInTheStrength) {
  const double slope = 30 * degree, suction = 4000;
  Problem<2> problem = wet_layer(8, slope, strength(34, 0, 0));
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) problem.initial_pressure[i] = -suction;
  problem.water_boundary = {PeriodicSides{"left", "right", "o"}, PressureSide{"top", -suction, "o"}};
  problem.stages[0].end_time = 1e-3;  // before it drains
  const double saturation = 0.087 + 0.913 * std::pow(1 + std::pow(suction / 4350, 1 / 0.39), -0.61);
  const double exact = exact::reduced_safety(
      load(dry_weight + 0.46 * saturation * 9810, slope, height * (1 - 0.5 / 8), -saturation * suction),
      {34 * degree, 0, 0});
  const double found = factor_at_end(problem);
  EXPECT_NEAR(found, exact, 0.02 * exact);
}

/// The run goes on as if nobody had asked.
TEST(StrengthReduction, TheRunIsNotTouched) {
  Problem<2> problem = wet_layer(4, 15 * degree, strength(40, 0, 0));
  problem.stages[0].largest_step = 0.25;
  Simulation<2> asked(problem), left(problem);
  while (!asked.finished()) {
    factor_of_safety(problem, asked.state(), {0.2, 2});
    asked.step();
    left.step();
  }
  test::expect_same_bits(asked.state(), left.state());
}

TEST(StrengthReduction, DividesWhatStrengthThereIs) {
  Soil soil = test::seed_sand(0.087);
  soil.elastic = Elastic{10e6, 0.3, "o"};
  soil.law = SuctionMohrCoulomb{strength(34, 1000, 5), 3000, 5, 0};
  const auto weak = std::get<SuctionMohrCoulomb>(*weakened(soil, 2).law);
  EXPECT_DOUBLE_EQ(std::tan(weak.saturated.friction), std::tan(34 * degree) / 2);
  EXPECT_DOUBLE_EQ(std::tan(weak.saturated.dilatancy), std::tan(5 * degree) / 2);
  EXPECT_EQ(weak.saturated.cohesion, 500);
  EXPECT_EQ(weak.suction_cohesion, 1500);
  soil.law = SuctionMohrCoulomb{strength(34, 1000, 5), 3000, 5, 0.1};
  EXPECT_THROW(weakened(soil, 2), CannotPlan);
  soil.law = ModifiedCamClay{1, 0.1, 0.01, 1, 1e5};
  EXPECT_THROW(weakened(soil, 2), CannotPlan);
  soil.law.reset();
  EXPECT_THROW(weakened(soil, 2), CannotPlan);
}

TEST(StrengthReduction, ABodyInMotionHasNone) {
  Problem<2> problem = layer(4, 25 * degree, strength(34, 0, 0));
  problem.stages[0].motion = SkeletonMotion::dynamic;
  const Simulation<2> simulation(problem);
  EXPECT_THROW(factor_of_safety(problem, simulation.state()), CannotPlan);
}

}  // namespace
}  // namespace wetfront::mpm
