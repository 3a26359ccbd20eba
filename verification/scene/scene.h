#pragma once

#include "meshes/rain_record.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// A scene says what is there: ground, soil, water, rain, gauges, and what is to be compared.
/// Everything is SI here; units were read and converted once, by the reader.
namespace wetfront::verification {

/// Where in the scene file something was said.
struct Origin {
  std::string file;
  int line = 0, column = 0;
  std::string text() const;  ///< "file:line:column"
};

/// A time that may be relative to the filling time (storage deficit / rain): "1800 s" or "25 % of filling".
struct SceneTime {
  double value = 0;  ///< s, or a fraction of the filling time
  bool of_filling = false;
  Origin origin;
};

struct Column {
  double height;  ///< m
  int cells;      ///< over the height
};
/// Inclined layer of constant vertical thickness.
struct Slope {
  double length;     ///< horizontal, m
  double thickness;  ///< vertical, m
  double angle;      ///< rad
  int cells_along, cells_over;
};
struct MeshFile {
  std::filesystem::path path;  ///< user's .msh, sides and regions as named physical groups
};
struct Geometry {
  std::variant<Column, Slope, MeshFile> shape;
  Origin origin;
};

struct Water {
  double density = 1000;        ///< kg/m3
  double bulk_modulus = 2.2e9;  ///< Pa
  double viscosity = 1e-3;      ///< Pa s
  Origin origin;
};

struct VanGenuchten {
  double air_entry;  ///< Pa
  double lambda;     ///< 1 - 1/n
  double s_min, s_max;
};
struct Exponential {
  double suction_scale;  ///< Pa
  double s_min, s_max;
};
using Retention = std::variant<VanGenuchten, Exponential>;

enum class PermeabilityLaw { mualem, printed_mualem, mualem_of_saturation, exponential, constant };

struct Elastic {
  double young, poisson;
  Origin origin;
};

struct Soil {
  std::string name;
  double porosity;
  double grain_density;           ///< kg/m3
  double intrinsic_permeability;  ///< m2 (a saturated conductivity in the scene is converted with water and gravity)
  std::optional<Retention> retention;
  PermeabilityLaw permeability = PermeabilityLaw::mualem;
  double permeability_suction_scale = 0;  ///< Pa, for PermeabilityLaw::exponential: k_rel = exp(-s / scale)
  std::optional<Elastic> elastic;         ///< absent: rigid skeleton
  Origin origin;
};

/// Hydrostatic above and below a water table, suction capped; or uniform.
struct HydrostaticStart {
  double water_table;  ///< elevation, m
  double suction_cap;  ///< Pa; infinity: none
};
struct UniformStart {
  double pressure;  ///< Pa, compression-positive
};
struct InitialState {
  std::variant<HydrostaticStart, UniformStart> pressure;
  Origin origin;
};

struct Rain {
  std::string side;
  meshes::RainRecord record;
  Origin origin;
};

enum class WaterCondition { impermeable, free_drainage, pressure, seepage_face };
struct Boundary {
  std::string side;
  std::optional<WaterCondition> water;
  double pressure = 0;                       ///< Pa, for WaterCondition::pressure
  std::optional<std::array<bool, 3>> fixed;  ///< skeleton: per axis
  Origin origin;
};

struct Probe {
  std::string name;
  std::array<double, 3> position{};
  Origin origin;
};

enum class Scheme { seepage, implicit_drag };
struct Stage {
  std::string name;
  std::optional<Scheme> scheme;  ///< absent in a dry scene
  SceneTime until;
  bool backward_euler = false;  ///< seepage: backward Euler in place of BDF2
  double time_tolerance = 1e-5;
  double largest_step = 0;  ///< s; 0: none
  double step_safety = 0.8;
  double local_damping = 0;
  bool printed_mass_balance = false;
  Origin origin;
};

struct MpmSettings {
  int points_per_cell = 4;
  Origin origin;
};

struct ReferenceSettings {
  int cells = 320;  ///< over the height of a column; other meshes are refined to at least this
  double tolerance = 1e-6;
  bool backward_euler = false;
  Origin origin;
};

/// A gate: `quantity` of the comparison at `at` (all comparison times when absent) must be within `value`.
struct Tolerance {
  std::string quantity;
  std::optional<SceneTime> at;
  std::string probe;  ///< for gauge quantities; empty: every probe
  double value;       ///< relative (1 %  -> 0.01) or SI, as the quantity says
  std::string reason;
  Origin origin;
};

struct Comparison {
  std::vector<SceneTime> times;
  std::vector<Tolerance> tolerances;
  Origin origin;
};

struct Scene {
  std::filesystem::path path;
  std::string text;  ///< the file as read
  std::string title, requirement;
  std::array<double, 3> gravity{0, -9.81, 0};  ///< m/s2, y up in two dimensions; zero: no gravity
  Origin gravity_origin;
  Geometry geometry;
  std::optional<Water> water;  ///< absent: a dry scene
  std::vector<Soil> soils;
  std::optional<InitialState> initial;
  std::vector<Rain> rains;
  std::vector<Boundary> boundaries;
  std::vector<Probe> probes;
  std::vector<Stage> stages;
  MpmSettings mpm;
  std::optional<ReferenceSettings> reference;  ///< absent: nothing to compare with (a dry scene)
  Comparison comparison;
};

}  // namespace wetfront::verification
