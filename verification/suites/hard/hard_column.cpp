#include "verification/suites/hard/hard_column.h"

#include "verification/suites/box_mesh.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

constexpr double density = 1000, viscosity = 1e-3, gravity = 9.81, weight = density * gravity;

mpm::Soil mpm_soil(const HardSoil& soil, std::size_t number) {
  mpm::Soil out;
  out.name = "soil " + std::to_string(number);
  out.porosity = soil.porosity;
  out.grain_density = 2690;
  out.intrinsic_permeability = soil.ks * viscosity / weight;
  out.retention = mpm::VanGenuchtenRetention{soil.air_entry, 1 - 1 / soil.n, soil.s_min, 1, soil.cut_off};
  out.permeability = mpm::MualemPermeability{};
  out.origin = "row: soil";
  return out;
}

fem::Soil fem_soil(const HardSoil& soil, double bulk_modulus) {
  fem::Soil out;
  out.name = "soil";
  out.retention = fem::VanGenuchten{soil.porosity * soil.s_min, soil.porosity, weight / soil.air_entry, soil.n,
                                    soil.cut_off / weight};
  out.conductivity = fem::MualemConductivity{};
  out.saturated_conductivity = soil.ks;
  out.specific_storage = soil.porosity * weight / bulk_modulus;  // 0 for infinite
  return out;
}

std::vector<double> elevations_of(const HardColumn& column, double height, int finer) {
  std::vector<double> z = column.elevations;
  if (z.empty())
    for (int k = 0; k <= column.cells; ++k) z.push_back(height * k / column.cells);
  std::vector<double> fine{z.front()};
  for (std::size_t k = 1; k < z.size(); ++k)
    for (int part = 1; part <= finer; ++part) fine.push_back(z[k - 1] + (z[k] - z[k - 1]) * part / finer);
  return fine;
}

void lay_soils(const HardColumn& column, meshes::Mesh& mesh) {
  std::vector<std::string> names;
  for (std::size_t s = 0; s < column.soils.size(); ++s) names.push_back("soil " + std::to_string(s));
  const auto up = static_cast<std::size_t>(meshes::up_axis(mesh.dim));
  name_regions(mesh, names, [&](const meshes::Point& at) { return static_cast<int>(column.soil_at(at[up])); });
}

}  // namespace

mpm::Problem<2> strip_problem(const HardColumn& column) {
  mpm::Problem<2> problem;
  const auto z = elevations_of(column, column.height, 1);
  const int cells = static_cast<int>(z.size()) - 1;
  problem.mesh = rectangle_mesh(column.height / cells, column.height, 1, cells);
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) problem.mesh.nodes[i][1] = z[i / 2];
  lay_soils(column, problem.mesh);
  problem.gravity = {0, -gravity};
  problem.gravity_origin = "row: gravity";
  problem.water = mpm::Water{density, column.bulk_modulus, viscosity, "row: water"};
  for (std::size_t s = 0; s < column.soils.size(); ++s) problem.soils.push_back(mpm_soil(column.soils[s], s));
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(column.pressure(node[1]));
  std::string top = "top";
  if (column.surface > 0) {
    top = mpm::free_surface;
    problem.surface = {{-1, column.surface, 0}, {2, column.surface, 0}};
  }
  if (!column.rain.start.empty() || !column.evaporation.start.empty())
    problem.water_boundary.push_back(
        mpm::RainSide{top, column.rain, "row: rain", column.evaporation, column.least_pressure});
  if (column.top_pressure) problem.water_boundary.push_back(mpm::PressureSide{"top", *column.top_pressure, "row: top"});
  if (column.base_pressure)
    problem.water_boundary.push_back(mpm::PressureSide{"base", *column.base_pressure, "row: base"});
  if (column.drains) problem.water_boundary.push_back(mpm::FreeDrainageSide{"base", "row: base"});
  mpm::Stage stage;
  stage.name = "water";
  stage.origin = "row: stage";
  stage.end_time = column.outputs.back();
  problem.stages = {stage};
  problem.output_times = {0};
  for (double time : column.outputs) problem.output_times.push_back(time);
  return problem;
}

fem::RichardsProblem line_problem(const HardColumn& column, int finer) {
  fem::RichardsProblem problem;
  const double height = column.surface > 0 ? column.surface : column.height;
  const auto z = elevations_of(column, height, finer);
  problem.mesh = line_mesh(height, static_cast<int>(z.size()) - 1);
  for (std::size_t i = 0; i < z.size(); ++i) problem.mesh.nodes[i][0] = z[i];
  lay_soils(column, problem.mesh);
  problem.gravity_direction = {-1, 0, 0};
  problem.unit_weight = weight;
  for (const HardSoil& soil : column.soils) problem.soils.push_back(fem_soil(soil, column.bulk_modulus));
  for (double elevation : z) problem.initial_head.push_back(column.pressure(elevation) / weight);
  if (!column.rain.start.empty() || !column.evaporation.start.empty())
    problem.boundary.push_back(fem::RainSide{"top", column.rain, column.evaporation, column.least_pressure / weight});
  if (column.top_pressure) problem.boundary.push_back(fem::HeadSide{"top", *column.top_pressure / weight});
  if (column.base_pressure) problem.boundary.push_back(fem::HeadSide{"base", *column.base_pressure / weight});
  if (column.drains) problem.boundary.push_back(fem::FreeDrainageSide{"base"});
  problem.output_times = {0};
  for (double time : column.outputs) problem.output_times.push_back(time);
  problem.end_time = column.outputs.back();
  return problem;
}

}  // namespace wetfront::verification
