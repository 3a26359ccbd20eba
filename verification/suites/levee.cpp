#include "verification/suites/levee.h"

#include "verification/suites/box_mesh.h"
#include "verification/suites/setups.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

constexpr double width = 14, height = 3, edge = 0.25, slope_width = 6;  // m

double surface(double x) {
  const double rise = (height - edge) / slope_width;
  return std::min({height, edge + rise * x, edge + rise * (width - x)});
}

}  // namespace

fem::RichardsProblem levee(int cells_along, int cells_over) {
  fem::RichardsProblem problem;
  problem.mesh = rectangle_mesh(width, 1, cells_along, cells_over);
  for (auto& node : problem.mesh.nodes) node[1] *= surface(node[0]);
  split_side(problem.mesh, "top", "waterside", [](const meshes::Point& at) { return at[0] < slope_width; });
  split_side(problem.mesh, "top", "landside", [](const meshes::Point& at) { return at[0] > width - slope_width; });
  problem.gravity_direction = {0, -1, 0};
  problem.soils = {van_genuchten_soil({0.065, 0.41, 7.5, 1.89, 4e-5})};
  problem.soils[0].name = "sandy loam";
  problem.soils[0].specific_storage = 0.41 * 9810 / 2.2e9;
  const meshes::RainRecord rain{{0}, {1e-3 / hour}};
  const fem::TimeRecord level{{0, 12 * hour}, {edge, 2.4}};
  problem.boundary = {fem::WaterLevelSide{"waterside", level, rain}, fem::WaterLevelSide{"left", level},
                      fem::RainSide{"top", rain}, fem::RainSide{"landside", rain}, fem::RainSide{"right", {}}};
  start_from(problem, [](const meshes::Point& at) { return edge - at[1]; });
  problem.output_times = {12 * hour, day, 2 * day, 4 * day};
  problem.end_time = 4 * day;
  problem.tolerance = 1e-4;
  return problem;
}

}  // namespace wetfront::verification
