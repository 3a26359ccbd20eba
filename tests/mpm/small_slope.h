#pragma once

#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// A slope that fails, slides and rests within seconds of computing.
namespace wetfront::mpm::test {

constexpr double degree = std::numbers::pi / 180;

/// Rain on a layer of sand, 0.6 m on a base that rises by 28 degrees over the middle part, with room above it.
inline Problem<2> slope(int along, int over) {
  const auto base = [](double x) { return std::tan(28 * degree) * std::clamp(x - 1.5, 0.0, 3.0); };
  Problem<2> problem = seed_column(2, 0.087, 2e-4, 600);
  problem.mesh = plane(along, 2 * over, [&](double u, double v) {
    return meshes::Point{6 * u, base(6 * u) + 1.2 * v, 0};
  });
  problem.surface = {{0, 0.6, 0}, {1.5, 0.6, 0}, {4.5, base(4.5) + 0.6, 0}, {6, base(6) + 0.6, 0}};
  problem.initial_pressure.assign(problem.mesh.node_count(), -3000);
  problem.water->bulk_modulus = 2e7;  // soft, for steps ten times as long
  problem.soils[0].elastic = Elastic{2e6, 0.3, "o"};
  problem.soils[0].law = MohrCoulomb{30 * degree, 0, 0, 0.0, "o"};
  problem.water_boundary = {RainSide{free_surface, {{0}, {2e-4}}, "o"}};
  problem.fixities = {
      {"base", {true, true, false}, "o"}, {"left", {true, false, false}, "o"}, {"right", {true, false, false}, "o"}};
  problem.initial_stress = InitialStress::k0;
  problem.skeleton.pic = 0.002;
  problem.probes.clear();
  problem.riders = {{"marker", {3, base(3) + 0.55, 0}, "o"}};
  Stage& rain = problem.stages[0];
  rain.motion = SkeletonMotion::quasi_static;
  rain.ends_with = StageEnd::failure;
  rain.time_tolerance = 1e-3;
  rain.relaxation.coupling_tolerance = 1e-3;
  Stage slide = rain;
  slide.name = "slide";
  slide.motion = SkeletonMotion::dynamic;
  slide.ends_with = StageEnd::rest;
  slide.end_time = rain.end_time + 3;
  slide.longest = 3;
  slide.picture_every = 0.5;
  problem.stages.push_back(slide);
  problem.output_times = {100};
  return problem;
}

/// The same with its lower half of a soil of its own, as given.
inline Problem<2> layered_slope(int along, int over, const Soil& lower) {
  Problem<2> problem = slope(along, over);
  problem.soils.push_back(lower);
  problem.mesh.region_names = {"upper", "lower"};
  for (int cell = 0; cell < along * (over / 2); ++cell) problem.mesh.region[static_cast<std::size_t>(cell)] = 1;
  return problem;
}

}  // namespace wetfront::mpm::test
