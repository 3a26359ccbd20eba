// The scheme semi-implicit: inertia of the liquid at the points, pressure and drag implicit on the grid.
#include "mpm/simulation.h"
#include "tests/mpm/strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>

namespace wetfront::mpm {
namespace {

Problem<2> with_scheme(Problem<2> problem, LiquidScheme scheme) {
  problem.stages[0].liquid = scheme;
  return problem;
}

TEST(SemiImplicit, AHydrostaticColumnStaysAtRest) {
  // physics.md section 2: H = 1 m, uncapped, unsaturated, no rain, 10 s: max|dp| <= 1 Pa, |w| <= 1e-9 m/s.
  Problem<2> problem = with_scheme(test::seed_column(40, 0.087, 0.0, 10), LiquidScheme::semi_implicit);
  problem.mesh = test::strip(1.0, 40);
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(-9810.0 * node[1]);
  problem.stages[0].largest_step = 0.1;
  problem.output_times = {0, 10};
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  const auto history = simulation.take_history();
  for (std::size_t i = 0; i < history.mesh.node_count(); ++i)
    EXPECT_NEAR(history.snapshots[1].node_pressure[i], history.snapshots[0].node_pressure[i], 1e-6);
  for (double q : simulation.state().fields.at("point.flux")) EXPECT_LE(std::abs(q), 1e-12);
}

TEST(SemiImplicit, AgreesWithSeepage) {
  // The liquid's own time is 1/r < 0.1 s: over minutes the two differ by their time integration alone (backward Euler
  // here, 0.1 % at tolerance 1e-4). Gate of the issue: 1 % of the pressure's size, cell averages.
  for (double end : {60.0, 300.0, 700.0}) {
    Problem<2> problem = test::seed_column(40, 0.87, 3e-5, end);
    problem.output_times = {end};
    const auto without = run<2>(problem);
    problem.stages[0].time_tolerance = 1e-4;
    const auto with = run<2>(with_scheme(problem, LiquidScheme::semi_implicit));
    double square = 0, size = 0;
    for (std::size_t c = 0; c < 40; ++c) {
      const double p = without.snapshots[0].cell_pressure[c], d = with.snapshots[0].cell_pressure[c] - p;
      square += d * d;
      size += p * p;
    }
    EXPECT_LE(std::sqrt(square / size), 0.01) << end;
    const auto &first = with.ledger.front(), &last = with.ledger.back();
    EXPECT_NEAR(last.stored - first.stored, last.infiltrated - last.outflow, 1e-8 * last.rain_asked);
    EXPECT_NEAR(last.stored_points, last.stored, 1e-4 * last.rain_asked);
  }
}

/// A saturated column, closed at the base, p = 0 at the top, its first mode let go: p = A(t) cos(k y), k = pi/(2 H).
/// n/K_l dp/dt = -dq/dy and rho/n dq/dt = -dp/dy - q/M give A'' + r A' + c^2 k^2 A = 0, c^2 = K_l/rho, r = n/(rho M).
double wave_error(int steps) {
  const int cells = 64;
  Problem<2> problem = with_scheme(test::seed_column(cells, 0.087, 0, 1), LiquidScheme::semi_implicit);
  problem.gravity = {};
  problem.soils[0].intrinsic_permeability = 3e-7;  // coarse gravel: the wave swings before drag stops it
  const double height = 1.2, pi = std::acos(-1.0), k = pi / (2 * height), amplitude = 1000, level = 1e5;
  const double c = std::sqrt(problem.water->bulk_modulus / problem.water->density);
  const double r = 0.46 * problem.water->viscosity / (problem.water->density * 3e-7);
  const double end = 0.75 * 2 * pi / (c * k);  // three quarters of a swing
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
    problem.initial_pressure[i] = level + amplitude * std::cos(k * problem.mesh.nodes[i][1]);
  problem.water_boundary = {PressureSide{"top", level, "test:top"}};
  problem.stages[0].end_time = end;
  problem.stages[0].time_tolerance = 1;  // largest_step sets the step
  problem.stages[0].largest_step = end / steps;
  problem.output_times = {end};
  const auto history = run<2>(problem);
  const std::complex<double> root = std::sqrt(std::complex<double>(0.25 * r * r - c * c * k * k));
  const auto exact = std::exp(-0.5 * r * end) * (std::cosh(root * end) + 0.5 * r / root * std::sinh(root * end));
  double worst = 0;
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
    worst = std::max(worst, std::abs((history.snapshots[0].node_pressure[i] - level) / amplitude -
                                     exact.real() * std::cos(k * problem.mesh.nodes[i][1])));
  return worst;
}

TEST(SemiImplicit, APressureWaveSwingsAsItsClosedFormSays) {
  // Without inertia the pressure would have fallen to 1e-2 of where it began, with one sign. Backward Euler damps by
  // (c k)^2 dt/2 per second: first order in dt.
  const double coarse = wave_error(400), fine = wave_error(800);
  EXPECT_LE(coarse, 0.04);
  EXPECT_NEAR(coarse / fine, 2, 0.15);
}

TEST(SemiImplicit, PrincipalAxesOfInertiaAndPermeabilityAreOne) {
  // A tensor 4 : 1 turned by 45 degrees in a scene turned by nothing: at long times it is Darcy's law.
  Problem<2> problem = test::seed_column(10, 0.087, 1e-4, 120);
  problem.soils[0].anisotropy = {2.5, 2.5, 1, 1.5, 0, 0};
  problem.output_times = {120};
  problem.stages[0].time_tolerance = 1e-4;
  problem.stages[0].integrator = TimeIntegrator::backward_euler;
  const auto without = run<2>(problem);
  const auto with = run<2>(with_scheme(problem, LiquidScheme::semi_implicit));
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
    EXPECT_NEAR(with.snapshots[0].node_pressure[i], without.snapshots[0].node_pressure[i], 20) << i;  // of 10 kPa
}

TEST(SemiImplicit, ACutRunGoesOnWithTheSameBits) {
  Problem<2> problem = with_scheme(test::seed_column(10, 0.087, 1e-4, 100), LiquidScheme::semi_implicit);
  problem.output_times = {100};
  const auto whole = run<2>(problem);
  Simulation<2> first(problem);
  for (int k = 0; k < 30; ++k) first.step();
  Simulation<2> second(problem, first.state());
  while (!second.finished()) second.step();
  EXPECT_EQ(second.take_history().snapshots[0].node_pressure, whole.snapshots[0].node_pressure);
}

}  // namespace
}  // namespace wetfront::mpm
