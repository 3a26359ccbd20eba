// What acts on the sides of a deforming skeleton, against closed forms.
#include "mpm/boundary/frictional_contact.h"
#include "mpm/simulation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace wetfront::mpm {
namespace {

constexpr double degree = 3.14159265358979323846 / 180, young = 10e6, poisson = 0.3;
const double modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));

Soil dry_soil() {
  Soil soil;
  soil.name = "soil";
  soil.porosity = 0.4;
  soil.grain_density = 2700;
  soil.elastic = Elastic{young, poisson, "test:elastic"};
  soil.origin = "test:soil";
  return soil;
}
const double density = 0.6 * 2700;

template <int dim>
Problem<dim> dry(meshes::Mesh mesh, double end) {
  Problem<dim> problem;
  problem.mesh = std::move(mesh);
  problem.gravity_origin = "test:gravity";
  problem.soils = {dry_soil()};
  problem.points_per_cell = dim == 2 ? 4 : 8;
  Stage stage;
  stage.name = "motion";
  stage.end_time = end;
  stage.origin = "test:stage";
  problem.stages = {stage};
  problem.output_times = {end};
  return problem;
}

Problem<2> bar(int cells, double end) {
  Problem<2> problem = dry<2>(test::strip(1, cells), end);
  problem.fixities = {
      {"base", {true, true, false}, "o"}, {"left", {true, false, false}, "o"}, {"right", {true, false, false}, "o"}};
  return problem;
}

/// All of the run, and its last state.
template <int dim>
State run_to_end(const Problem<dim>& problem) {
  Simulation<dim> simulation(problem);
  while (!simulation.finished()) simulation.step();
  return simulation.state();
}
double mean(const std::vector<double>& values, std::size_t component, std::size_t components) {
  const std::size_t n = values.size() / components;
  return std::accumulate(values.begin() + static_cast<long>(component * n),
                         values.begin() + static_cast<long>((component + 1) * n), 0.0) /
         static_cast<double>(n);
}

TEST(Tractions, ABarUnderPressureShortensByItsStiffness) {
  Problem<2> problem = bar(20, 0.4);
  problem.stages[0].local_damping = 0.3;
  problem.skeleton_boundary = {Traction{"top", 20e3, {}, {}, "test:load"}};
  const State state = run_to_end(problem);
  const double settlement = -state.history.snapshots.at(0).node_displacement[40][1];
  // The load is dead while the bar shortens by 0.15 %; ten periods of damping leave less than that.
  EXPECT_NEAR(settlement / (20e3 / modulus), 1, 3e-3);
  EXPECT_NEAR(mean(state.fields.at("point.stress"), 1, 4) / -20e3, 1, 2e-3);
}

TEST(Tractions, AVectorAndAFactorInTimeActAsSaid) {
  Problem<2> problem = bar(10, 0.4);
  problem.stages[0].local_damping = 0.3;
  problem.skeleton_boundary = {Traction{"top", 0, {0, 30e3, 0}, {{0, 0.1}, {0, 0.5}}, "test:load"}};
  const State state = run_to_end(problem);
  EXPECT_NEAR(mean(state.fields.at("point.stress"), 1, 4) / 15e3, 1, 2e-3);
}

// Half a cell filled at the top: the load acts where the surface is, not at the mesh border.
TEST(Tractions, TheFreeSurfaceCarriesALoadInsideACell) {
  Problem<2> problem = bar(20, 0.4);
  problem.surface = {{0, 0.925, 0}, {0.05, 0.925, 0}};
  problem.stages[0].local_damping = 0.3;
  problem.skeleton_boundary = {Traction{free_surface, 20e3, {}, {}, "test:load"}};
  const State state = run_to_end(problem);
  EXPECT_NEAR(mean(state.fields.at("point.stress"), 1, 4) / -20e3, 1, 2e-3);
}

TEST(Tractions, ALoadOnASideThatTheMeshLacksIsRefused) {
  Problem<2> problem = bar(4, 0.1);
  problem.skeleton_boundary = {Traction{"roof", 1, {}, {}, "test:load"}};
  EXPECT_THROW(run<2>(problem), CannotPlan);
}

/// A block of 4 x 4 cells in a mesh 12 (or more) cells long and 6 high, moving at 2 m/s to the right while it shears
/// and vibrates; the mesh's ends are one when `tied`.
Problem<2> passing_block(int columns, bool tied, Transfer transfer, double end) {
  constexpr double h = 0.1;
  Problem<2> problem = dry<2>(test::box(columns * h, 6 * h, columns, 6), end);
  problem.skeleton.transfer = transfer;
  problem.skeleton.integration = StressIntegration::points;
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c) {
    const std::size_t column = c % static_cast<std::size_t>(columns), row = c / static_cast<std::size_t>(columns);
    problem.empty_cells.push_back(column >= 7 && column < 11 && row >= 1 && row < 5 ? 0 : 1);
  }
  problem.initial_velocity = [](const std::array<double, 2>& x) {
    return std::array<double, 2>{2 + 0.2 * std::sin(5 * x[1]), 0.1 * std::cos(4 * x[1])};
  };
  if (tied) problem.skeleton_boundary = {PeriodicSkeleton{"left", "right", "test:ties"}};
  return problem;
}

struct Passed {
  double mass = 0, momentum = 0, kinetic = 0, stress = 0, handed = 0, held = 0, moved = 0;
};
Passed pass(const Problem<2>& problem) {
  const State end = run_to_end(problem);
  const auto &mass = end.fields.at("point.mass"), &v = end.fields.at("point.velocity"),
             &stress = end.fields.at("point.stress"), &x = end.fields.at("point.position");
  Passed out;
  const std::size_t n = mass.size();
  for (std::size_t p = 0; p < n; ++p) {
    out.mass += mass[p];
    out.momentum += mass[p] * v[p];
    out.kinetic += 0.5 * mass[p] * (v[p] * v[p] + v[n + p] * v[n + p]);
    out.moved += x[p] / static_cast<double>(n);
  }
  for (double s : stress) out.stress += s * s;
  const auto& counters = end.history.counters;
  if (counters.contains("points handed to the periodic partner"))
    out.handed = counters.at("points handed to the periodic partner");
  out.held = counters.at("points held at the mesh border");
  return out;
}

/// 1.2 m: through the end of the mesh with all its points, and on to where it began. In a mesh so long that it needs no
/// other end it does the same, so that nothing can be seen of the ends but round-off of sums taken in another order.
TEST(PeriodicSides, ABlockThatPassesThemIsTheBlockThatDoesNot) {
  for (const Transfer transfer : {Transfer::flip, Transfer::apic}) {
    const Passed tied = pass(passing_block(12, true, transfer, 0.6)),
                 free = pass(passing_block(36, false, transfer, 0.6));
    EXPECT_EQ(tied.handed, 64);
    EXPECT_EQ(tied.held + free.held, 0);
    EXPECT_NEAR(tied.mass / free.mass, 1, 1e-14);
    EXPECT_NEAR(tied.momentum / free.momentum, 1, 1e-12);
    // APIC strains light nodes with part of their acceleration, and weighs tied ones without their partners.
    const bool exact = transfer == Transfer::flip;
    EXPECT_NEAR(tied.kinetic / free.kinetic, 1, exact ? 1e-9 : 1e-7);
    EXPECT_NEAR(tied.stress / free.stress, 1, exact ? 1e-6 : 1e-3);
    EXPECT_NEAR(tied.moved, free.moved - 1.2, 1e-9);
    EXPECT_GT(free.stress, 1e6);
  }
}

TEST(PeriodicSides, AStraightPassStrainsNothing) {
  Problem<2> problem = passing_block(12, true, Transfer::flip, 0.6);
  problem.initial_velocity = [](const std::array<double, 2>&) { return std::array<double, 2>{2, 0}; };
  const Passed passed = pass(problem);
  EXPECT_EQ(passed.handed, 64);
  EXPECT_LT(std::sqrt(passed.stress), 1e-12 * young);
  EXPECT_NEAR(passed.momentum / (2 * passed.mass), 1, 1e-13);
}

/// It falls along the ends' way: what it is lifted by when it comes in again is no energy.
TEST(PeriodicSides, ABodyThatFallsThroughThemKeepsItsEnergy) {
  Problem<2> problem = passing_block(12, true, Transfer::flip, 0.5);
  problem.gravity = {9.81, 0};
  const State end = run_to_end(problem);
  const auto& motion = end.history.motion;
  EXPECT_EQ(end.history.counters.at("points handed to the periodic partner"), 2 * 64);
  EXPECT_LT(std::abs(motion.back().drift), 2e-3 * motion.back().kinetic);
}

TEST(MovingSides, AGivenMotionStrainsTheBar) {
  Problem<2> problem = bar(20, 0.2);
  problem.stages[0].local_damping = 0.5;
  // 1 mm down until 0.1 s, then held.
  MovingSide press{"top", {}, {{0, 0.1, 0.1}, {1, 1, 0}}, "test:side"};
  press.velocity[1] = -0.01;
  problem.skeleton_boundary = {press};
  const State state = run_to_end(problem);
  EXPECT_NEAR(state.history.snapshots.at(0).node_displacement[40][1], -1e-3, 1e-9);
  EXPECT_NEAR(mean(state.fields.at("point.stress"), 1, 4) / (modulus * -1e-3), 1, 2e-3);
}

TEST(MovingSides, AQuasiStaticStepEndsWhereTheSideShouldBe) {
  Problem<2> problem = bar(10, 1);
  problem.stages[0].motion = SkeletonMotion::quasi_static;
  problem.stages[0].largest_step = 0.25;
  MovingSide press{"top", {}, {}, "test:side"};
  press.velocity[1] = -0.001;
  problem.skeleton_boundary = {press};
  const State state = run_to_end(problem);
  EXPECT_NEAR(state.history.snapshots.at(0).node_displacement[20][1], -1e-3, 1e-11);
  // Every step ends within 2e-4 of equilibrium.
  EXPECT_NEAR(mean(state.fields.at("point.stress"), 1, 4) / (modulus * -1e-3), 1, 2e-3);
}

/// A pulse in the middle of a long bar: half of it leaves through the absorbing base, the other half is thrown back by
/// the free top and leaves too. What is left of the energy.
double energy_left(bool shear) {
  const double speed = std::sqrt((shear ? young / (2 * (1 + poisson)) : modulus) / density);
  Problem<2> problem = bar(100, 2.2 / speed);
  problem.fixities.clear();
  if (shear)
    problem.skeleton_boundary = {PeriodicSkeleton{"left", "right", "test:ties"}};
  else
    problem.fixities = {{"left", {true, false, false}, "o"}, {"right", {true, false, false}, "o"}};
  problem.skeleton_boundary.push_back(AbsorbingSide{"base", "test:base"});
  problem.initial_velocity = [shear](const Vector<2>& x) {
    const double v = 1e-3 * std::exp(-std::pow((x[1] - 0.5) / 0.08, 2));
    return shear ? Vector<2>{v, 0} : Vector<2>{0, v};
  };
  const State state = run_to_end(problem);
  const auto& stress = state.fields.at("point.stress");
  const std::size_t n = stress.size() / 4;
  double stored = 0;
  for (std::size_t p = 0; p < n; ++p) {
    const double s = stress[(shear ? 3 : 1) * n + p];
    stored += 0.5 * s * s / (shear ? young / (2 * (1 + poisson)) : modulus) * state.fields.at("point.volume")[p];
  }
  return (state.history.motion.back().kinetic + stored) / state.history.motion.front().kinetic;
}
TEST(AbsorbingSides, WavesLeave) {
  // Lysmer's dashpots take a plane wave whole; lumped mass and cells of an eighth of the pulse leave 1 % of amplitude.
  EXPECT_LT(energy_left(false), 1e-3);
  EXPECT_LT(energy_left(true), 1e-3);
}

TEST(AbsorbingSides, WhatCarriedTheBodyGoesOnCarryingIt) {
  Problem<2> problem = bar(20, 0.1);
  problem.gravity = {0, -9.81};
  problem.fixities = {{"left", {true, false, false}, "o"}, {"right", {true, false, false}, "o"}};
  problem.skeleton_boundary = {AbsorbingSide{"base", "test:base"}};
  problem.initial_stress = InitialStress::k0;
  const State state = run_to_end(problem);
  for (const auto& u : state.history.snapshots.at(0).node_displacement) EXPECT_NEAR(u[1], 0, 1e-9);
}

// --- contact ---

template <int dim>
Vector<dim> nearest_by_search(const Vector<dim>& v, const std::vector<Vector<dim>>& normals,
                              const std::vector<double>& approach) {
  Vector<dim> x = v;
  std::vector<double> lambda(normals.size(), 0);
  for (int turn = 0; turn < 20000; ++turn)
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const double change = std::max(dot<dim>(normals[k], x) - approach[k], -lambda[k]);
      lambda[k] += change;
      for (int a = 0; a < dim; ++a) x[a] -= change * normals[k][a];
    }
  return x;
}
template <int dim>
void expect_nearest(int planes) {
  std::mt19937 random(static_cast<unsigned>(planes));
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Vector<dim>> normals(static_cast<std::size_t>(planes));
    Vector<dim> v;
    for (double& x : v) x = normal(random);
    for (auto& n : normals) {
      for (double& x : n) x = normal(random);
      n[dim - 1] = -std::abs(n[dim - 1]) - 0.3;  // a base: all face downwards, so there is a way out
      const double size = length<dim>(n);
      for (double& x : n) x /= size;
    }
    std::vector<double> impulse(normals.size()), approach(normals.size());
    for (double& b : approach) b = std::max(normal(random), 0.0);  // half of them are touched
    const Vector<dim> found = without_penetration<dim>(v, {normals, approach}, impulse),
                      wanted = nearest_by_search<dim>(v, normals, approach);
    for (int a = 0; a < dim; ++a) ASSERT_NEAR(found[a], wanted[a], 1e-6);
    for (double one : impulse) ASSERT_GE(one, 0);
  }
}
TEST(Contact, TheNearestVelocityGoesIntoNoPlane) {
  for (int planes : {1, 2, 3}) expect_nearest<2>(planes);
  for (int planes : {1, 2, 4}) expect_nearest<3>(planes);
}

/// A layer, periodic along the slope of 30 degrees.
Problem<2> layer(double mu, double end) {
  Problem<2> problem = dry<2>(test::box(0.4, 0.4, 4, 4), end);
  problem.gravity = {9.81 * std::sin(30 * degree), -9.81 * std::cos(30 * degree)};
  problem.skeleton_boundary = {PeriodicSkeleton{"left", "right", "test:ties"},
                               FrictionalContact{"base", mu, "test:base"}};
  return problem;
}
// Let go without stress the layer bounces on its base, and friction follows the reaction R: int R dt = m g cos t + P_n,
// so P_t = m g sin t - mu int R dt at every instant. With P_n = 0, a = g (sin - mu cos) of benchmarks.md section 6.
TEST(Contact, ALayerSlidesByCoulombsLaw) {
  const double mass = 0.16 * density, end = 0.08;
  for (const auto& [mu, wanted] : {std::pair{0.0, 4.905}, {0.2, 3.20585816}}) {
    const State state = run_to_end(layer(mu, end));
    const auto& row = state.history.motion.back();
    EXPECT_NEAR((row.momentum[0] + mu * row.momentum[1]) / (mass * end), wanted, 1e-7) << mu;  // the printed digits
    EXPECT_NEAR(row.momentum[0] / (mass * end), wanted, 0.05) << mu;
    for (std::size_t a = 0; a < 2; ++a)
      EXPECT_NEAR(row.momentum_drift[a], 0, 1e-12 * mass * 9.81 * end) << mu;  // round-off of a hundred steps
  }
}
TEST(Contact, ABlockSlidesInThreeDimensions) {
  const double mu = 0.2, end = 0.06, side = std::sqrt(0.5);
  Problem<3> problem = dry<3>(test::pillar(0.1, 1), end);
  problem.gravity = {4.905 * side, 4.905 * side, -9.81 * std::cos(30 * degree)};
  problem.skeleton_boundary = {FrictionalContact{"base", mu, "test:base"}};
  const State state = run_to_end(problem);
  const auto& row = state.history.motion.back();
  const double mass = 1e-3 * density;
  EXPECT_NEAR(row.momentum[0] / row.momentum[1], 1, 1e-9);
  // The block swells sideways as it is squeezed, which turns friction of a node from the slope line: 1 % of the issue.
  EXPECT_NEAR((side * (row.momentum[0] + row.momentum[1]) + mu * row.momentum[2]) / (mass * end), 3.20585816, 0.032);
}
TEST(Contact, ALayerSticksWhereFrictionHolds) {
  Problem<2> problem = layer(0.6, 1);
  problem.stages[0].motion = SkeletonMotion::quasi_static;
  problem.stages[0].relaxation.most_iterations = 200000;  // of a mesh of a hundred cells; this has four
  problem.stages.push_back(problem.stages[0]);
  problem.stages[1].motion = SkeletonMotion::dynamic;
  problem.stages[1].end_time = 1.05;
  problem.output_times = {1, 1.05};
  const State state = run_to_end(problem);
  const auto& before = state.history.snapshots.at(0).node_displacement;
  const auto& after = state.history.snapshots.at(1).node_displacement;
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t a = 0; a < 2; ++a) {
      // 6 mm of free fall otherwise; relaxation leaves 2e-4 of the forces, a tenth of a micrometre of this layer.
      EXPECT_NEAR(after[i][a], before[i][a], 1e-6) << i;
      if (i < 5) {
        EXPECT_NEAR(after[i][a], before[i][a], 1e-9) << i;  // the base itself
      }
    }
}

/// The layer saturated, water flowing along a slope of 15 degrees: p is hydrostatic across it.
Problem<2> soaked_layer(double mu) {
  const double slope = 15 * degree;
  Problem<2> problem = layer(mu, 1);
  problem.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope)};
  problem.water = test::seed_water();
  problem.soils[0].intrinsic_permeability = 1e-11;
  problem.soils[0].retention = VanGenuchtenRetention{4350, 0.61, 0.1, 1.0};
  problem.soils[0].permeability = MualemPermeability{};
  for (const auto& node : problem.mesh.nodes)
    problem.initial_pressure.push_back(9810 * std::cos(slope) * (0.4 - node[1]));
  problem.water_boundary = {PressureSide{"top", 0, "test:top"}, PeriodicSides{"left", "right", "test:ties"}};
  problem.stages[0].liquid = LiquidScheme::seepage;
  problem.stages[0].motion = SkeletonMotion::quasi_static;
  problem.stages[0].relaxation.most_iterations = 100000;
  return problem;
}
// Friction acts on the effective reaction: at rest while mu (gamma_sat - gamma_w) cos > gamma_sat sin, from mu = 0.531;
// on the total one it would be from tan 15 = 0.268.
TEST(Contact, WaterTakesItsPartOfTheReaction) {
  EXPECT_NO_THROW(run<2>(soaked_layer(0.56)));
  EXPECT_ANY_THROW(run<2>(soaked_layer(0.50)));  // it does not come to rest, or flow and skeleton never agree
}

TEST(Contact, TheBaseLetsGoAndNeverPulls) {
  Problem<2> problem = layer(0.5, 0.02);
  problem.gravity = {0, 5};  // upwards
  problem.surface = {{0, 0.2, 0}, {0.4, 0.2, 0}};
  const State state = run_to_end(problem);
  const auto& velocity = state.fields.at("point.velocity");
  EXPECT_NEAR(mean(velocity, 1, 2), 5 * 0.02, 1e-9);
}

/// A strip of soil on a base with a kink, concave or convex: no point of it ever lies below.
void expect_above(double before, double after) {
  Problem<2> problem = dry<2>(test::plane(12, 3,
                                          [&](double u, double v) {
                                            const double x = 1.2 * u;
                                            const double z = x < 0.6 ? before * (0.6 - x) : -after * (x - 0.6);
                                            return meshes::Point{x, z + 0.3 * v, 0};
                                          }),
                              0.35);
  problem.gravity = {0, -9.81};
  problem.empty_cells.assign(36, 1);
  for (int j = 0; j < 2; ++j)
    for (int i = 3; i < 6; ++i) problem.empty_cells[static_cast<std::size_t>(12 * j + i)] = 0;
  problem.soils[0].law = MohrCoulomb{30 * degree, 2e3, 0, {}, "test:law"};
  problem.skeleton_boundary = {FrictionalContact{"base", 0.1, "test:base"}};
  const State state = run_to_end(problem);
  const auto& x = state.fields.at("point.position");
  const std::size_t n = x.size() / 2;
  double farthest = 0;
  for (std::size_t p = 0; p < n; ++p) {
    const double z = x[p] < 0.6 ? before * (0.6 - x[p]) : -after * (x[p] - 0.6);
    EXPECT_GT(x[n + p], z) << x[p];
    farthest = std::max(farthest, x[p]);
  }
  EXPECT_GT(farthest, 0.7);  // it has gone over the kink
  const auto held = state.history.counters.find("points held at the mesh border");
  if (held != state.history.counters.end()) {
    EXPECT_EQ(held->second, 0);
  }
}
TEST(Contact, NothingGoesThroughAKinkedBase) {
  expect_above(0.8, 0.0);
  expect_above(0.6, 1.2);
}

TEST(Contact, AContinuedRunGivesTheSameBits) {
  const Problem<2> problem = layer(0.2, 0.01);
  Simulation<2> whole(problem), first(problem);
  for (int k = 0; k < 20; ++k) {
    whole.step();
    first.step();
  }
  Simulation<2> second(problem, first.state());
  for (int k = 0; k < 20; ++k) {
    whole.step();
    second.step();
  }
  const State one = whole.state(), other = second.state();
  for (const auto& [name, values] : one.fields) EXPECT_EQ(values, other.fields.at(name)) << name;
}

// --- the stress of the beginning ---

/// Nodal velocities after one step from rest: the out-of-balance force.
double unrest(const Problem<2>& problem) {
  Simulation<2> simulation(problem);
  simulation.step();
  const State state = simulation.state();
  double worst = 0;
  for (double v : state.fields.at("point.velocity")) worst = std::max(worst, std::abs(v));
  return worst / simulation.time();
}
TEST(InitialStress, ALevelColumnIsAtRest) {
  Problem<2> problem = bar(10, 0.01);
  problem.gravity = {0, -9.81};
  problem.initial_stress = InitialStress::k0;
  EXPECT_LT(unrest(problem), 1e-11 * 9.81);  // round-off
  problem.surface = {{0, 0.93, 0}, {0.1, 0.93, 0}};
  EXPECT_LT(unrest(problem), 1e-9 * 9.81);  // seeding of a cut cell
  problem.initial_stress = InitialStress::none;
  EXPECT_GT(unrest(problem), 1);
}

TEST(InitialStress, TheRatioIsThatOfTheSoilAndLoadsCount) {
  Problem<2> problem = bar(10, 0.01);
  problem.gravity = {0, -9.81};
  problem.initial_stress = InitialStress::k0;
  problem.soils[0].earth_pressure_at_rest = 0.8;
  problem.skeleton_boundary = {Traction{"top", 7e3, {}, {}, "test:load"}};
  EXPECT_LT(unrest(problem), 1e-11 * 9.81 * 7);
  const State state = Simulation<2>(problem).state();
  const auto& stress = state.fields.at("point.stress");
  const auto& x = state.fields.at("point.position");
  const std::size_t n = x.size() / 2;
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_NEAR(stress[n + p], -7e3 - density * 9.81 * (1 - x[n + p]), 1e-8);
    EXPECT_NEAR(stress[p] / stress[n + p], 0.8, 1e-12);
    EXPECT_NEAR(stress[2 * n + p] / stress[n + p], 0.8, 1e-12);
  }
}

/// Water hydrostatic around a level, in soil that holds some of it by suction.
Problem<2> wet_column(double level) {
  Problem<2> problem = bar(20, 10);
  problem.gravity = {0, -9.81};
  problem.water = test::seed_water();
  problem.soils[0].intrinsic_permeability = 1e-11;
  problem.soils[0].retention = VanGenuchtenRetention{4350, 0.61, 0.1, 1.0};
  problem.soils[0].permeability = MualemPermeability{};
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(9810 * (level - node[1]));
  problem.stages[0].liquid = LiquidScheme::seepage;
  problem.stages[0].motion = SkeletonMotion::quasi_static;
  problem.initial_stress = InitialStress::k0;
  return problem;
}
TEST(InitialStress, IsEffectiveWhereThereIsWater) {
  const Problem<2> problem = wet_column(0.5);
  const auto saturation = [](double p) {
    return p > 0 ? 1.0 : 0.1 + 0.9 * std::pow(1 + std::pow(-p / 4350, 1 / 0.39), -0.61);
  };
  const State state = Simulation<2>(problem).state();
  const auto& stress = state.fields.at("point.stress");
  const auto& x = state.fields.at("point.position");
  const std::size_t n = x.size() / 2;
  for (std::size_t p = 0; p < n; ++p) {
    const double z = x[n + p], pressure = 9810 * (0.5 - z);
    double weight = density * 9.81 * (1 - z);
    const int parts = 2000;
    for (int k = 0; k < parts; ++k)
      weight += 0.4 * 9810 * (1 - z) / parts * saturation(9810 * (0.5 - z - (k + 0.5) / parts * (1 - z)));
    // The run begins with a relaxation: chi p of a cell's points becomes its mean over the cell, here 5 Pa apart.
    EXPECT_NEAR(stress[n + p], -weight + saturation(pressure) * pressure, 10) << z;
  }
}
TEST(InitialStress, WaterOnTheSoilWeighsAndBearsAlike) {
  Problem<2> problem = wet_column(3);  // two metres of it
  problem.skeleton_boundary = {Traction{"top", 2 * 9810, {}, {}, "test:water"}};
  const State state = Simulation<2>(problem).state();
  const auto& stress = state.fields.at("point.stress");
  const auto& x = state.fields.at("point.position");
  const std::size_t n = x.size() / 2;
  for (std::size_t p = 0; p < n; ++p)
    EXPECT_NEAR(stress[n + p], -(0.6 * (2700 - 1000) * 9.81) * (1 - x[n + p]), 1);  // water 2e4 Pa denser: 1e-4 of it
}
TEST(InitialStress, AWetColumnStaysWhereItIs) {
  const State state = run_to_end(wet_column(0.5));
  // Without it the column settles by 0.6 mm. What is left: water of a node against water of its points in cells of 5
  // cm.
  for (const auto& u : state.history.snapshots.at(0).node_displacement) EXPECT_NEAR(u[1], 0, 3e-6);
}

}  // namespace
}  // namespace wetfront::mpm
