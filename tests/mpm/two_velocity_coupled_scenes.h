#pragma once

#include "tests/mpm/two_velocity_limit_scenes.h"

/// Closed bodies with a deforming skeleton for the coupled step limit.
namespace wetfront::mpm::test {

struct CoupledCondition {
  const char* name;
  double pressure, permeability, young, bulk_modulus;
};
/// The seed's sand saturated, with hardly any drag, with the real stiffness of water, and in two unsaturated states; a
/// skeleton stiffer than its water.
inline constexpr CoupledCondition coupled_conditions[] = {
    {"saturated", 1e5, 3e-11, 10e6, 0.2e9},    {"saturated, gravel", 1e5, 1e-8, 10e6, 0.2e9},
    {"stiff water", 1e5, 3e-11, 10e6, 2.15e9}, {"stiff skeleton", 1e5, 1e-9, 1e9, 0.2e9},
    {"-500 Pa", -500, 3e-11, 10e6, 0.2e9},     {"-3 kPa", -3e3, 3e-11, 10e6, 0.2e9},
};

/// Rollers on all sides, no weight, a uniform state.
inline Problem<2> coupled_body(const meshes::Mesh& mesh, const CoupledCondition& condition, LiquidScheme scheme) {
  Problem<2> problem = uniform_body(mesh, condition.pressure, scheme);
  problem.stages[0].end_time = 1e4;  // of which the steps are no vanishing part
  problem.water->bulk_modulus = condition.bulk_modulus;
  problem.soils[0].intrinsic_permeability = condition.permeability;
  problem.soils[0].elastic = Elastic{condition.young, 0.3, "test:elastic"};
  for (const auto& side : mesh.sides) {
    const bool level = side.name == "base" || side.name == "top";
    problem.fixities.push_back({side.name, {!level, level, false}, "test:roller"});
  }
  return problem;
}

}  // namespace wetfront::mpm::test
