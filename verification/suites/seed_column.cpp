#include "verification/suites/seed_column.h"

#include "verification/suites/setups.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

constexpr double height = 1.2, porosity = 0.46, unit_weight = 9810, suction_cap = 10e3 / unit_weight;

exact::VanGenuchten sand(double s_min) {
  return {porosity * s_min, porosity, unit_weight / 4350, 1 / (1 - 0.61), seed_conductivity};
}

double start(double elevation) {
  return std::max(-elevation, -suction_cap);
}

}  // namespace

double SeedColumn::filling_time() const {
  const exact::VanGenuchten soil = sand(s_min);
  constexpr int parts = 24000;  // midpoints: what they leave, h2/24, is below 1e-9 of the deficit
  double deficit = 0;
  for (int i = 0; i < parts; ++i)
    deficit += (soil.theta_s - soil.content(start((i + 0.5) * height / parts))) * height / parts;
  return deficit / rain;
}

fem_reference::RichardsProblem SeedColumn::problem(int cells, const std::vector<double>& shares) const {
  std::vector<double> times;
  for (const double share : shares) times.push_back(share * filling_time());
  fem_reference::RichardsProblem problem = column(height, cells, 0, times);
  problem.soils = {van_genuchten_soil(sand(s_min))};
  problem.soils[0].specific_storage = porosity * unit_weight / 0.2e9;
  problem.boundary = {fem_reference::RainSide{"top", {{0}, {rain}}}};
  start_from(problem, [](const meshes::Point& at) { return start(at[0]); });
  problem.gauges = {{"base", {0, 0, 0}}, {"surface", {height, 0, 0}}};
  return problem;
}

}  // namespace wetfront::verification
