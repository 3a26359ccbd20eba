#pragma once

#include "verification/scene/origin.h"
#include "verification/scene/place_table.h"
#include "verification/scene/skeleton.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a scene says of its soils. Suctions s >= 0 in Pa; S is water over pores; Se = (S - s_min) / (s_max - s_min).
namespace wetfront::verification {

/// van Genuchten 1980: Se = [1 + (s / air_entry)^(1/(1-lambda))]^-lambda.
struct VanGenuchten {
  double air_entry;  ///< Pa; rho g / alpha
  double lambda;     ///< 1 - 1/n
  double s_min, s_max;
  double cut_off = 0;  ///< full up to this suction, the curve scaled to meet it there [Pa]; 0: none
};
/// Gardner 1958: Se = exp(-s / suction_scale).
struct Exponential {
  double suction_scale;  ///< Pa
  double s_min, s_max;
};
/// Haverkamp et al. 1977, sand; Vauclin et al. 1979 with s_min = 0: Se = a / (a + (h / head_unit)^beta), h = s / (rho
/// g).
struct Haverkamp {
  double a, beta;
  double head_unit;  ///< m; of the paper that a stands in
  double s_min, s_max;
};
/// Haverkamp et al. 1977, Yolo clay: Se = a / (a + ln(h / head_unit)^beta) for h > head_unit, else 1.
struct HaverkampLog {
  double a, beta;
  double head_unit;  ///< m
  double s_min, s_max;
};
/// Broadbridge & White 1988.
struct BroadbridgeWhite {
  double c;                ///< > 1
  double sorptive_length;  ///< m
  double s_min, s_max;
};
/// Measured points; suctions ascend from 0, saturations do not rise.
struct TabulatedRetention {
  std::vector<double> suction;     ///< Pa
  std::vector<double> saturation;  ///< -
};
using Retention =
    std::variant<VanGenuchten, Exponential, Haverkamp, HaverkampLog, BroadbridgeWhite, TabulatedRetention>;

enum class PermeabilityLaw {
  mualem,
  printed_mualem,
  mualem_of_saturation,
  exponential,
  constant,
  haverkamp,
  broadbridge_white,
  tabulated
};

/// k_rel = a / (a + (h / head_unit)^gamma): Haverkamp et al. 1977, Vauclin et al. 1979.
struct HaverkampPermeability {
  double a = 0, gamma = 0;
  double head_unit = 0;  ///< m
};
/// Measured points; suctions ascend from 0, where k_rel is 1, and k_rel does not rise.
struct TabulatedPermeability {
  std::vector<double> suction;   ///< Pa
  std::vector<double> relative;  ///< -
};

/// Principal conductivities as factors on the saturated one; `along` is turned from x towards up by `angle`.
struct Anisotropy {
  double along, across;  ///< across: upwards before turning
  double sideways;       ///< third direction of a box in space
  double angle;          ///< rad
  Origin origin;
};

/// chi of the effective stress sigma' = sigma + chi p.
enum class Bishop { saturation, effective_saturation };

struct Soil {
  std::string name;
  double porosity;
  double grain_density;           ///< kg/m3
  double intrinsic_permeability;  ///< m2 (a saturated conductivity in the scene is converted with water and gravity)
  std::optional<Retention> retention;
  PermeabilityLaw permeability = PermeabilityLaw::mualem;
  double permeability_suction_scale = 0;  ///< Pa, for PermeabilityLaw::exponential: k_rel = exp(-s / scale)
  HaverkampPermeability haverkamp{};      ///< for PermeabilityLaw::haverkamp
  TabulatedPermeability table{};          ///< for PermeabilityLaw::tabulated
  std::optional<Anisotropy> anisotropy{};
  std::optional<PlaceTable> conductivity_field{};  ///< factors on the conductivity
  std::optional<double> specific_storage{};        ///< 1/m; absent: n rho g / K_l
  std::optional<Elastic> elastic;                  ///< absent: rigid skeleton
  std::optional<Strength> strength{};              ///< absent: the skeleton stays elastic
  std::optional<double> earth_pressure_at_rest{};  ///< K_0; absent: nu/(1-nu)
  Bishop bishop = Bishop::saturation;
  Origin origin;
};

}  // namespace wetfront::verification
