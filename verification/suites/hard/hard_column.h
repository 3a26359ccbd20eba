#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/suites/hard/hard_case.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// A soil in the terms of its users; water has 1000 kg/m3, 1e-3 Pa s and g = 9.81 m/s2 in all rows.
struct HardSoil {
  double ks = 2.943e-4;  ///< m/s
  double porosity = 0.46;
  double air_entry = 4350;    ///< van Genuchten's p0 = rho g / alpha [Pa]
  double n = 1 / (1 - 0.61);  ///< van Genuchten's n
  double s_min = 0.087;
  double cut_off = 0;  ///< Pa
};

/// A column told once, from which the MPM's strip and the reference's line are made.
struct HardColumn {
  double height = 1.2;  ///< m
  int cells = 40;
  /// Elevations of the nodes from 0 to height [m]; empty: equal cells.
  std::vector<double> elevations{};
  /// Soil at an elevation (of a cell's centre), among `soils`.
  std::vector<HardSoil> soils = std::vector<HardSoil>(1);
  std::function<std::size_t(double)> soil_at = [](double) { return 0; };
  std::function<double(double)> pressure = [](double) { return -10e3; };  ///< Pa at an elevation [m]
  meshes::RainRecord rain{};                                              ///< on top; empty: none
  meshes::RainRecord evaporation{};                                       ///< the same side
  double least_pressure = -1.5e6;                                         ///< Pa, of evaporation
  std::optional<double> top_pressure{}, base_pressure{};                  ///< Pa, held
  bool drains = false;                                                    ///< free drainage at the base
  double bulk_modulus = 0.2e9;                                            ///< Pa; infinite: incompressible water
  double surface = 0;           ///< m; 0: the mesh ends at the surface, else the soil does there, inside a cell
  std::vector<double> outputs;  ///< s; the last one ends the run
};

mpm::Problem<2> strip_problem(const HardColumn& column);
/// On cells `finer` times as small.
fem_reference::RichardsProblem line_problem(const HardColumn& column, int finer);

/// Water in the soil below each of the elevations [m3/m2], by the lumped nodes (which conserve it) where the record
/// holds nodal values, by the cells where it holds averages; `soil` gives S(p).
std::vector<double> water_below(const HardColumn& column, const meshes::Mesh& mesh, const meshes::Snapshot& shot,
                                const std::vector<double>& elevations);

/// How far the water that came or moved lies from where the reference has it, on average [cells]: the area between the
/// two curves of water below an elevation, over the water moved. A front that lags by one cell counts one.
double misplaced_water(const HardColumn& column, const meshes::FieldHistory& mpm,
                       const meshes::FieldHistory& reference);

/// Largest difference of the nodal pressures at the end from the reference's, where the reference is wetter than
/// `driest` [Pa].
double pressure_difference(const meshes::FieldHistory& mpm, const meshes::FieldHistory& reference, double driest);

/// What a column's row asks besides the scene.
struct ColumnRow {
  std::string name, title, requirement, source;
  Effort effort = Effort::quick;
  HardColumn column;
  std::vector<double> ends;  ///< as HardCase; empty: the last output
  double seepage_until = 0;
  double budget = 4;
  double cells_off = 1;  ///< bound on misplaced_water [cells]
  std::string reason{};
  int finer = 4;  ///< the reference's cells
  /// The bound grows by what the reference itself misplaces on the same cells: where no mesh of this size can know
  /// better.
  bool known_to_own_change = false;
};
HardCase column_case(const ColumnRow& row);

}  // namespace wetfront::verification
