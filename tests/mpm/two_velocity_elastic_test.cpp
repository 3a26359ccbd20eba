#include "mpm/plan.h"
#include "mpm/stress_law.h"
#include "tests/mpm/two_velocity_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// The two-velocity pore liquid in an elastic skeleton.
namespace wetfront::mpm::test {
namespace {

double saturation(const Problem<2>& problem, double p) {
  const auto& spec = std::get<VanGenuchtenRetention>(*problem.soils[0].retention);
  const double x = std::pow(std::max(0.0, -p) / spec.air_entry, 1 / (1 - spec.lambda));
  return spec.s_min + (spec.s_max - spec.s_min) * std::pow(1 + x, -spec.lambda);
}

/// The start of a strip whose effective stresses carry its own weight: the total stress of a cell balances the lumped
/// weight of all nodes above it, sigma' = sigma + S p (Bishop). Cells have four points.
State balanced_start(const Problem<2>& problem) {
  Simulation<2> simulation(problem);
  State state = simulation.state();
  const auto &volume = state.fields.at("point.volume"), &water = state.fields.at("point.water"),
             &mass = state.fields.at("point.mass");
  const std::size_t cells = problem.mesh.cell_count(), points = volume.size();
  std::vector<double>& stress = state.fields.at("point.stress");
  const double width = problem.mesh.nodes[1][0];
  double above = 0;  // weight above the cell's centre: half of a cell sits on each of its nodes
  for (std::size_t c = cells; c-- > 0;) {
    double weight = 0, wet = 0, volume_of_cell = 0;
    for (std::size_t q = 4 * c; q < 4 * c + 4; ++q) {
      weight += 9.81 * (mass[q] + 1000 * water[q]) / width;
      wet += water[q];
      volume_of_cell += volume[q];
    }
    const double p = 0.5 * (problem.initial_pressure[2 * c] + problem.initial_pressure[2 * c + 2]);
    EXPECT_NEAR(wet / volume_of_cell, 0.46 * saturation(problem, p), 1e-4);
    const double effective = -(above + 0.5 * weight) + saturation(problem, p) * p;
    for (std::size_t q = 4 * c; q < 4 * c + 4; ++q) stress[points + q] = effective;
    above += weight;
  }
  return state;
}

/// physics.md section 2: the static test, skeleton included.
TEST(TwoVelocityElastic, HydrostaticColumnInBalanceRests) {
  const Problem<2> problem = with_elastic_skeleton(at_rest(20, 10));
  Simulation<2> simulation(problem, balanced_start(problem));
  const auto start = simulation.take_history().snapshots.at(0);
  while (!simulation.finished()) simulation.step();
  const auto end = simulation.take_history().snapshots.at(1);
  double pressure = 0, displacement = 0;
  for (std::size_t c = 0; c < end.cell_pressure.size(); ++c)
    pressure = std::max(pressure, std::abs(end.cell_pressure[c] - start.cell_pressure[c]));
  for (const auto& u : end.node_displacement) displacement = std::max(displacement, std::abs(u[1]));
  EXPECT_LE(pressure, 1.0);
  EXPECT_LE(largest(simulation.state().fields.at("node.Darcy flux")), 1e-9);
  EXPECT_LE(displacement, 1e-9);
}

}  // namespace
}  // namespace wetfront::mpm::test
