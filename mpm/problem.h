#pragma once

#include "meshes/field_history.h"
#include "meshes/mesh.h"
#include "meshes/rain_record.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

/// What the material point method is asked to simulate. The plan of effects, columns and kernels is
/// derived from it (plan.h): there is no switch here that turns physics on or off, only things that
/// are there (water, rain, an elastic skeleton) or are not.
///
/// Sign convention of all of mpm/: stress is tension-positive; pore pressure p is
/// compression-positive [Pa]; suction s = -p. SI units throughout.
namespace wetfront::mpm {

/// "file:line" of the scene entry that asked for a thing; `explain` prints it.
using Origin = std::string;

struct Water {
  double density;       ///< kg/m3
  double bulk_modulus;  ///< Pa
  double viscosity;     ///< Pa s
  Origin origin;
};

/// Lee et al. 2021, Eq. 5: S = S_min + (S_max - S_min) [1 + (s/p0)^{1/(1-lambda)}]^-lambda for s > 0.
struct VanGenuchtenRetention {
  double air_entry;  ///< p0 [Pa]
  double lambda;     ///< -
  double s_min, s_max;
};
/// Gardner: S = S_min + (S_max - S_min) exp(-s / p_c) for s > 0.
struct ExponentialRetention {
  double suction_scale;  ///< p_c [Pa]
  double s_min, s_max;
};
using RetentionSpec = std::variant<VanGenuchtenRetention, ExponentialRetention>;

/// Mualem on van Genuchten, corrected (benchmarks: Eq. 7 misprints the exponent):
/// k_rel = Se^1/2 [1 - (1 - Se^{1/lambda})^lambda]^2.
struct MualemPermeability {};
/// Eq. 7 of Lee et al. 2021 as printed: k_rel = Se^1/2 [1 - (1 - Se^{1/lambda})^2]. A research variant.
struct PrintedMualemPermeability {};
/// Mualem fed with S instead of the effective saturation Se: a defect seen in other codes, kept as a variant.
struct MualemOfSaturationPermeability {};
struct ExponentialPermeability {
  double suction_scale;  ///< k_rel = exp(-s / scale) [Pa]
};
struct ConstantPermeability {};
using PermeabilitySpec = std::variant<MualemPermeability, PrintedMualemPermeability, MualemOfSaturationPermeability,
                                      ExponentialPermeability, ConstantPermeability>;

/// Linear isotropic elasticity of the skeleton (effective stress).
struct Elastic {
  double young;    ///< Pa
  double poisson;  ///< -
  Origin origin;
};

struct Soil {
  std::string name;
  double porosity;
  double grain_density;                          ///< kg/m3
  double intrinsic_permeability;                 ///< m2
  std::optional<RetentionSpec> retention;        ///< absent in a dry scene
  std::optional<PermeabilitySpec> permeability;  ///< absent in a dry scene
  std::optional<Elastic> elastic;                ///< absent: rigid skeleton
  Origin origin;
};

/// Rain per horizontal area on a side; what the soil does not take runs off. A record without rain is a
/// potential seepage face.
struct RainSide {
  std::string side;
  meshes::RainRecord rain;
  Origin origin;
};
struct PressureSide {
  std::string side;
  double pressure;  ///< Pa
  Origin origin;
};
/// Unit gradient of total head: water leaves at K(p).
struct FreeDrainageSide {
  std::string side;
  Origin origin;
};
using WaterBoundary = std::variant<RainSide, PressureSide, FreeDrainageSide>;  // other sides are impermeable

/// Skeleton fixed on a side: per axis, true = no displacement along that axis.
struct Fixity {
  std::string side;
  std::array<bool, 3> fixed{};
  Origin origin;
};

struct Probe {
  std::string name;
  meshes::Point position{};
  Origin origin;
};

/// How the pore liquid moves in a stage.
enum class LiquidScheme {
  seepage,        ///< no inertia, implicit on the grid: backward Euler or BDF2 with error control
  implicit_drag,  ///< two velocities, momentum balances, drag implicit per node (Lee 2021 with Eq. 4/18 corrected)
};
enum class TimeIntegrator { bdf2, backward_euler };  ///< of `seepage`
/// Liquid mass balance of the two-velocity schemes.
enum class MassBalance {
  conservative,  ///< d(n S rho)/dt = -div(rho n S (v_l - v_s)) - rho n S div v_s
  printed_2021,  ///< Eqs 4/18 of Lee et al. 2021 as printed: loses (v_l - v_s).grad(nS). A research variant
};
enum class RainScheme { martinelli_2020 };  ///< of the two-velocity schemes: nodal correction

struct Stage {
  std::string name;
  std::optional<LiquidScheme> liquid;  ///< absent in a dry scene
  double end_time = 0;                 ///< s
  TimeIntegrator integrator = TimeIntegrator::bdf2;
  double time_tolerance = 1e-5;  ///< relative, of the error control of `seepage`: leaves less than the mesh does
  double largest_step = 0;       ///< s; 0: none but the scheme's own limit
  double step_safety = 0.8;      ///< fraction of the stability limit used by conditionally stable schemes
  double local_damping = 0;      ///< of the skeleton's out-of-balance force (Cundall), dynamic stages
  MassBalance mass_balance = MassBalance::conservative;
  Origin origin;
};

/// A strip one cell wide (a column) or a plane-strain mesh for dim 2; dim 3 likewise.
template <int dim>
struct Problem {
  meshes::Mesh mesh;
  std::array<double, dim> gravity{};  ///< m/s2; zero: no gravity effect
  Origin gravity_origin;
  std::optional<Water> water;            ///< absent: a dry scene
  std::vector<Soil> soils;               ///< one per mesh region
  std::vector<double> initial_pressure;  ///< Pa at the mesh nodes; empty in a dry scene
  std::vector<WaterBoundary> water_boundary;
  std::vector<Fixity> fixities;
  std::vector<Probe> probes;
  int points_per_cell = 4;
  std::vector<Stage> stages;         ///< in order, `end_time` ascending
  std::vector<double> output_times;  ///< s, ascending, within [0, end of the last stage]
};

/// The plan cannot be made or a boundary condition cannot act: the message says which, why and what to do.
struct CannotPlan : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The run stopped (no step converges, blow-up detected); `partial` keeps everything computed until then.
struct GaveUp : std::runtime_error {
  GaveUp(const std::string& message, meshes::FieldHistory kept)
      : std::runtime_error(message), partial(std::move(kept)) {}
  meshes::FieldHistory partial;
};

}  // namespace wetfront::mpm
