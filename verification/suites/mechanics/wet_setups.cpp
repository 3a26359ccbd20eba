#include "verification/suites/mechanics/wet_setups.h"

#include "verification/suites/mechanics/motion_setups.h"

namespace wetfront::verification {

double intrinsic(double conductivity) {
  return conductivity * 1e-3 / 9810;
}

mpm::Problem<2> wet_problem(const WetColumn& c, mpm::LiquidScheme scheme, const std::vector<double>& times) {
  mpm::Soil soil = dry_soil(1, c.young, c.poisson);
  soil.porosity = c.porosity;
  soil.grain_density = c.grain_density;
  soil.intrinsic_permeability = intrinsic(c.conductivity);
  soil.retention = mpm::VanGenuchtenRetention{4350, 0.61, 0.087, 1.0};
  soil.permeability = mpm::MualemPermeability{};
  auto problem = dry_problem<2>(rectangle_mesh(c.height / c.cells, c.height, 1, c.cells), soil, times);
  problem.water = mpm::Water{1000, c.water_modulus, 1e-3, "suite"};
  problem.initial_pressure.assign(problem.mesh.node_count(), 0);
  add_rollers(problem, {"base", "left", "right"});
  mpm::Traction load;
  load.side = "top";
  load.pressure = c.load;
  load.origin = "suite";
  // A jump: seepage would take what acts from the beginning on as borne by the skeleton already.
  if (scheme == mpm::LiquidScheme::seepage) load.factor = {{0, 0}, {0, 1}};
  problem.skeleton_boundary.push_back(load);
  problem.stages[0].liquid = scheme;
  const bool still = scheme == mpm::LiquidScheme::seepage;
  if (c.drained && still) problem.water_boundary.push_back(mpm::PressureSide{"top", 0, "suite"});
  if (c.drained && !still) problem.water_boundary.push_back(mpm::RainSide{"top", {}, "suite"});  // a seepage face
  problem.stages[0].motion = still ? mpm::SkeletonMotion::quasi_static : mpm::SkeletonMotion::dynamic;
  return problem;
}

}  // namespace wetfront::verification
