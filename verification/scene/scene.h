#pragma once

#include "verification/scene/conditions.h"
#include "verification/scene/geometry.h"
#include "verification/scene/origin.h"
#include "verification/scene/soil.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A scene says what is there: ground, soil, water, rain, gauges, and what is to be compared.
/// Everything is SI here; units were read and converted once, by the reader.
namespace wetfront::verification {

/// A time that may be relative to the filling time (storage deficit / rain): "1800 s" or "25 % of filling".
struct SceneTime {
  double value = 0;  ///< s, or a fraction of the filling time
  bool of_filling = false;
  Origin origin;
};

struct Water {
  double density = 1000;        ///< kg/m3
  double bulk_modulus = 2.2e9;  ///< Pa
  double viscosity = 1e-3;      ///< Pa s
  Origin origin;
};

struct Probe {
  std::string name;
  std::array<double, 3> position{};
  Origin origin;
};

/// The ladder of schemes, cheapest first; `auto` in a scene becomes one of them when it is read.
enum class Scheme { seepage, semi_implicit, implicit_drag, explicit_drag };
struct Stage {
  std::string name;
  std::optional<Scheme> scheme;  ///< absent in a dry scene
  SceneTime until;
  bool backward_euler = false;  ///< seepage: backward Euler in place of BDF2
  double time_tolerance = 1e-5;
  double largest_step = 0;  ///< s; 0: none
  double step_safety = 0.8;
  double local_damping = 0;
  SkeletonMotion motion{};
  StageEvent event{};
  std::optional<double> lasts{};  ///< s since its own beginning at most, in place of `until`
  double picture_every = 0;       ///< s; 0: none
  bool printed_mass_balance = false;
  Origin origin;
};

/// Where rain enters when the surface lies inside cells: the program's own way, or a named one of the literature.
enum class RainEntry { standard, martinelli_2020, bandara_2016, consistent_flux };

struct MpmSettings {
  int points_per_cell = 4;
  int threads = 1;
  double water_softening = 1;  ///< bulk modulus of the MPM's water over the scene's, which the reference keeps
  double surface_in_cell = 1;  ///< filled fraction of the topmost row of cells, in (0, 1]
  RainEntry rain_entry = RainEntry::standard;
  double cpu_budget = 86400;  ///< s: nobody waits longer for what he did not mean to ask for
  double accuracy = 0;  ///< relative error of pressure that the run refines itself to; 0: as the scene's cells give it
  Origin origin;
};

/// Mesh refinement of the reference towards wetting fronts.
struct AdaptiveMesh {
  int levels;        ///< halvings of a cell at most
  double threshold;  ///< water content that the indicator may reach before a cell is halved
};

struct ReferenceSettings {
  int cells = 320;  ///< over the height of a column; other meshes are refined to at least this
  double tolerance = 1e-6;
  enum class Integrator { bdf, backward_euler, dirk } integrator = Integrator::bdf;
  int degree = 1;
  std::optional<AdaptiveMesh> adaptive{};
  /// Storage of an elastic skeleton: Bishop's parameter is S, or Se.
  enum class SkeletonStorage { none, saturation, effective_saturation } skeleton = SkeletonStorage::none;
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

/// What is known of a quantity (compare/body_outcomes.h): shown beside what comes out, never gated.
struct Observation {
  std::string quantity;             ///< "arrival_time:G-9"
  std::string measured, simulated;  ///< as their sources say it; empty: they do not
  std::string remark;
  Origin origin;
};

struct Comparison {
  std::vector<SceneTime> times;
  std::vector<Tolerance> tolerances;
  double second_mesh = 1;  ///< the MPM runs again with so many times as many cells each way; 1: it does not
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
  std::vector<Evaporation> evaporations;
  std::vector<Boundary> boundaries;
  std::vector<Probe> probes;
  std::vector<Probe> riders;  ///< points of the soil that are followed
  std::vector<Stage> stages;
  SkeletonSettings skeleton;
  MpmSettings mpm;
  std::optional<ReferenceSettings> reference;  ///< absent: nothing to compare with (a dry scene)
  Comparison comparison;
  std::vector<Observation> observations;
};

/// Whether a soil is elastic: the skeleton of the scene deforms, with its own laws, sides and stages.
bool deforms(const Scene& scene);
/// Whether a stage ends with failure or rest.
bool has_events(const Scene& scene);

}  // namespace wetfront::verification
