#pragma once

#include "meshes/rain_record.h"
#include "verification/scene/geometry.h"
#include "verification/scene/origin.h"
#include "verification/scene/place_table.h"
#include "verification/scene/skeleton.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What a scene says of the start and of the sides. Pore pressure is compression-positive: suction is negative.
namespace wetfront::verification {

/// Hydrostatic above and below a water table, suction capped.
struct HydrostaticStart {
  double water_table;  ///< elevation, or height above the base, m
  double suction_cap;  ///< Pa; infinity: none
  /// The water table runs parallel to the lower end of the ground, that high above it; else it is level, or `line`.
  bool over_base = false;
  Polyline line{};  ///< elevation over x, in place of `water_table`; empty: none
};
struct UniformStart {
  double pressure;  ///< Pa
};
/// Pressure over elevation: linear between the rows (a repeated elevation is a jump), constant beyond them.
struct ProfileStart {
  std::vector<double> elevation;  ///< m, not falling
  std::vector<double> pressure;   ///< Pa
};
/// One pressure per soil; a node between two soils has the mean of theirs.
struct SoilStart {
  std::vector<std::pair<std::string, double>> pressure;  ///< Pa
};
/// The steady state under a constant rain on the sides that are rained on (and what else holds at the start).
struct SteadyStart {
  double rain;  ///< m/s
};
/// The reference, run over a record of rain before the start.
struct SpinUpStart {
  meshes::RainRecord rain;  ///< s from the start of the spin-up
  double duration;          ///< s
  HydrostaticStart from;
};
/// Pressures at points, from a file of points or of fields.
struct FieldStart {
  PlaceTable pressure;         ///< Pa
  std::filesystem::path file;  ///< a .vtu to be read instead; empty: none
};
struct InitialState {
  std::variant<HydrostaticStart, UniformStart, ProfileStart, SoilStart, SteadyStart, SpinUpStart, FieldStart> pressure;
  Origin origin;
};

struct Rain {
  std::string side;
  meshes::RainRecord record;
  Origin origin;
};

struct Evaporation {
  std::string side;
  meshes::RainRecord demand;  ///< m/s, >= 0, per horizontal area
  double least_pressure;      ///< Pa: no drier than this by evaporation
  Origin origin;
};

/// Linear in time between the rows, constant before and after; two rows at one time are a jump.
struct Record {
  std::vector<double> time;   ///< s, not falling
  std::vector<double> value;  ///< SI
  bool constant() const { return value.size() == 1; }
};

enum class WaterCondition {
  impermeable,
  free_drainage,
  pressure,
  seepage_face,
  total_head,
  flux,
  water_level,
  as_at_start,
  periodic
};
struct Boundary {
  std::string side;
  std::optional<WaterCondition> water;
  double pressure = 0;          ///< Pa, for WaterCondition::pressure that does not vary
  Record record{};              ///< pressure [Pa], total head [m] or level [m] in time
  meshes::RainRecord inflow{};  ///< m/s per area of the side, either sign, for WaterCondition::flux
  double least_pressure = 0;    ///< Pa; of a flux out
  std::string partner{};        ///< for what is periodic
  std::optional<SkeletonCondition> skeleton{};
  std::optional<Record> load{};                     ///< pressure on the skeleton, compression-positive [Pa]
  std::optional<std::array<Record, 2>> traction{};  ///< force on the skeleton per area of the side, along x and y [Pa]
  Origin origin;
};

}  // namespace wetfront::verification
