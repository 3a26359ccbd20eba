#pragma once

#include "tests/mpm/plane.h"
#include "tests/mpm/two_velocity_scenes.h"

#include <gtest/gtest.h>

#include <random>

/// Scenes and a bisection for the step limits of the two-velocity schemes.
///
/// A closed body in a uniform state, its cells' water disturbed at random by parts in a million, runs at a factor of
/// the formula: `step_safety`, which may exceed 1 here. The state stays uniform to those parts, so that the formula
/// does not change while it is tested; neither growth of steps (from the second on they are equal) nor the look-ahead
/// (nothing fills) nor `largest_step` (none) takes part.
namespace wetfront::mpm::test {

/// 8 x 8 cells of 3 cm, sheared by `shear` (dx/dy).
inline meshes::Mesh sheared_box(double shear) {
  return plane(8, 8, [shear](double u, double v) { return meshes::Point{0.24 * (u + shear * v), 0.24 * v, 0}; });
}

/// A closed body without weight in a uniform state.
inline Problem<2> uniform_body(const meshes::Mesh& mesh, double pressure, LiquidScheme scheme) {
  Problem<2> problem = seed_column(1, 0.087, 0, 1e9);
  problem.stages[0].liquid = scheme;
  problem.mesh = mesh;
  problem.gravity = {0, 0};
  problem.water_boundary.clear();
  problem.initial_pressure.assign(mesh.node_count(), pressure);
  return problem;
}

struct Body {
  const char* name;
  meshes::Mesh mesh;
};

inline std::vector<Body> bodies() {
  return {{"strip", strip(0.6, 20)},
          {"squares", sheared_box(0)},
          {"parallelograms", sheared_box(0.6)},
          {"unstructured", crooked_box(0.24, 0.24, 8, 8)}};
}

/// Saturated with much and with little drag, and two unsaturated states in which drag rules.
struct Condition {
  const char* name;
  double pressure, permeability;
};
inline constexpr Condition conditions[] = {
    {"saturated", 1e5, 3e-11}, {"saturated, gravel", 1e5, 1e-8}, {"-500 Pa", -500, 3e-11}, {"-3 kPa", -3e3, 3e-11}};

/// A strip of ten cells and a box of squares, filled up to a line that leaves f of the top cell, or slopes through
/// cells.
inline std::vector<std::pair<std::string, Problem<2>>> cut_bodies(LiquidScheme scheme) {
  std::vector<std::pair<std::string, Problem<2>>> cut;
  for (double f : {0.02, 0.1, 0.5, 0.9, 1.0}) {
    cut.emplace_back("strip, f = " + std::to_string(f), uniform_body(strip(0.3, 10), -500, scheme));
    const double top = 0.03 * (9 + f);
    if (f < 1) cut.back().second.surface = {{-1, top, 0}, {1, top, 0}};
  }
  for (double slope : {0.1, 0.5}) {
    cut.emplace_back("box, slope " + std::to_string(slope), uniform_body(sheared_box(0), -500, scheme));
    cut.back().second.surface = {{-1, 0.14 - slope * 1.1, 0}, {1, 0.14 + slope * 0.9, 0}};
  }
  return cut;
}

struct Trial {
  double growth;        ///< of the largest disturbance, last over first
  std::string stopped;  ///< why, if it did
  double dt;            ///< of the last step [s]
};

/// sigma' = S p where the skeleton deforms: no total stress anywhere, so that a uniform body rests whatever its shape.
inline void balance_by_effective_stress(const Problem<2>& problem, State& state) {
  const auto stress = state.fields.find("point.stress");
  if (stress == state.fields.end()) return;
  const auto &water = state.fields.at("point.water"), &volume = state.fields.at("point.volume");
  const double p = problem.initial_pressure[0], c = 1 + p / problem.water->bulk_modulus;
  for (std::size_t q = 0; q < water.size(); ++q)
    for (std::size_t k = 0; k < 3; ++k)  // xx, yy, zz
      stress->second[k * water.size() + q] = water[q] / (problem.soils[0].porosity * volume[q]) / c * p;
}

/// Runs `steps` steps at `factor` times the formula's limit.
inline Trial run_at(Problem<2> problem, double factor, int steps) {
  problem.stages[0].step_safety = factor;
  State state = Simulation<2>(problem).state();
  auto& water = state.fields.at("point.water");
  const auto per_volume = [&volume = state.fields.at("point.volume")](const std::vector<double>& w, std::size_t q) {
    return w[q] / volume[q];
  };
  const double mean =
      std::accumulate(water.begin(), water.end(), 0.0) /
      std::accumulate(state.fields.at("point.volume").begin(), state.fields.at("point.volume").end(), 0.0);
  const auto disturbance = [&](const std::vector<double>& w) {
    double most = 0;
    for (std::size_t q = 0; q < w.size(); ++q) most = std::max(most, std::abs(per_volume(w, q) / mean - 1));
    return most;
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1e-6, 1e-6);
  std::size_t q = 0;
  for (double count : state.fields.at("points per cell")) {
    const double change = part(random);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) water[q++] *= 1 + change;
  }
  balance_by_effective_stress(problem, state);
  const double before = disturbance(water);
  // The guard of runs (mpm/record/run_guard.h) knows initial heads, not disturbances: give it heads to go by.
  problem.initial_pressure[0] += 1e5;
  Simulation<2> simulation(problem, state);
  double dt = 0;
  try {
    for (int step = 0; step < steps; ++step) {
      const double start = simulation.time();
      simulation.step();
      dt = simulation.time() - start;
    }
  } catch (const GaveUp& gave_up) {
    return {std::numeric_limits<double>::infinity(), gave_up.what(), dt};
  }
  return {disturbance(simulation.state().fields.at("point.water")) / before, "", dt};
}

/// The factor of the formula, from 1 to 4, at which disturbances begin to grow, to 1 %; 0 and 9 where it lies below
/// or above. In 400 steps a hundredth beyond the limit lets the mode that decides grow 50-fold or more; a stable one
/// keeps below ten times the start.
inline double bisected_factor(const Problem<2>& problem) {
  const auto is_stable = [&problem](double factor) { return run_at(problem, factor, 400).growth < 10; };
  double stable = 1, unstable = 4;
  if (!is_stable(stable)) return 0;
  if (is_stable(unstable)) return 9;
  while (unstable - stable > 0.01) {
    const double middle = 0.5 * (stable + unstable);
    (is_stable(middle) ? stable : unstable) = middle;
  }
  return stable;
}

/// Name of a test with the scheme as its parameter.
inline std::string scheme_of_test(const testing::TestParamInfo<LiquidScheme>& info) {
  return info.param == LiquidScheme::explicit_drag ? "ExplicitDrag" : "ImplicitDrag";
}

}  // namespace wetfront::mpm::test
