#pragma once

#include "meshes/field_history.h"
#include "meshes/mesh.h"
#include "meshes/rain_record.h"

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

/// The finite-element reference: Richards' equation in mixed form, in terms of pressure head
/// psi [m] (negative where unsaturated) and volumetric water content theta(psi) [-].
/// This header is std-only: deal.II and SUNDIALS stay behind it.
namespace wetfront::fem_reference {

/// van Genuchten 1980: Se = [1 + (-alpha psi)^n]^-m, m = 1 - 1/n, theta = theta_r + (theta_s - theta_r) Se.
struct VanGenuchten {
  double theta_r, theta_s;
  double alpha;  ///< 1/m
  double n;
  /// Cut-off at an air-entry suction [m]: saturated for psi >= -air_entry, Se = Se_vG / Se_vG(-air_entry) below,
  /// Mualem's integral cut at the same place (Vogel, van Genuchten & Cislerova 2001; Ippisch, Vogel & Bastian 2006). 0:
  /// none.
  double air_entry = 0;
};
/// Gardner 1958: Se = exp(alpha psi).
struct ExponentialRetention {
  double theta_r, theta_s;
  double alpha;  ///< 1/m
};
/// Haverkamp et al. 1977, sand; with theta_r = 0 Vauclin et al. 1979: Se = a / (a + |psi|^beta).
struct HaverkampRetention {
  double theta_r, theta_s;
  double a;  ///< m^beta: a printed for centimetres times 0.01^beta
  double beta;
};
/// Haverkamp et al. 1977, Yolo clay: Se = a / (a + ln(|psi| / entry)^beta) for psi < -entry, else 1.
struct HaverkampLogRetention {
  double theta_r, theta_s;
  double a;  ///< dimensionless
  double beta;
  double entry = 0.01;  ///< the unit of length in the logarithm [m]; 1 cm in the paper
};
/// Broadbridge & White 1988: psi / lambda = 1 - 1/Se - ln[(c - Se) / ((c - 1) Se)] / c. Dry (theta_r) is psi =
/// -infinity.
struct BroadbridgeWhiteRetention {
  double theta_r, theta_s;
  double c;       ///< > 1
  double lambda;  ///< sorptive length [m]
};
/// Measured points, interpolated monotonely with a continuous slope (Fritsch & Carlson 1980). Below the driest head the
/// content stays what it is there.
struct TabulatedRetention {
  std::vector<double> head;     ///< m, ascending; the last is 0
  std::vector<double> content;  ///< theta [-], not falling; the last is theta_s
};
using Retention = std::variant<VanGenuchten, ExponentialRetention, HaverkampRetention, HaverkampLogRetention,
                               BroadbridgeWhiteRetention, TabulatedRetention>;

/// Mualem 1976 on van Genuchten: K/Ks = Se^1/2 [1 - (1 - Se^{1/m})^m]^2.
struct MualemConductivity {};
/// Gardner 1958: K/Ks = exp(alpha psi).
struct ExponentialConductivity {
  double alpha;  ///< 1/m
};
struct ConstantConductivity {};
/// Haverkamp et al. 1977, Vauclin et al. 1979: K/Ks = a / (a + |psi|^gamma).
struct HaverkampConductivity {
  double a;  ///< m^gamma: a printed for centimetres times 0.01^gamma
  double gamma;
};
/// Broadbridge & White 1988: K/Ks = (c - 1) Se^2 / (c - Se), with their retention curve.
struct BroadbridgeWhiteConductivity {};
/// ln(K/Ks) interpolated as in TabulatedRetention; constant below the driest head.
struct TabulatedConductivity {
  std::vector<double> head;      ///< m, ascending; the last is 0
  std::vector<double> relative;  ///< K/Ks [-], positive, not falling; the last is 1
};
using Conductivity = std::variant<MualemConductivity, ExponentialConductivity, ConstantConductivity,
                                  HaverkampConductivity, BroadbridgeWhiteConductivity, TabulatedConductivity>;

struct Soil {
  std::string name;
  Retention retention;
  Conductivity conductivity;
  double saturated_conductivity;  ///< Ks [m/s]
  double specific_storage = 0;    ///< sigma = n rho g / K_l [1/m], acts where saturated only; 0: incompressible water
  double porosity = 0;            ///< n, so that S = theta / n; 0: theta_s, i.e. S_max = 1
};

/// Rain per horizontal area; what the soil does not take runs off (psi <= 0 complementary to run-off >= 0).
/// A record without rain makes the side a seepage face.
struct RainSide {
  std::string side;
  meshes::RainRecord rain;
};
struct HeadSide {
  std::string side;
  double head;  ///< prescribed psi [m]
};
/// Unit gradient of total head: water leaves at K(psi).
struct FreeDrainageSide {
  std::string side;
};
using BoundaryCondition = std::variant<RainSide, HeadSide, FreeDrainageSide>;  // a side without one is impermeable

struct Gauge {
  std::string name;
  meshes::Point position;
};

enum class Integrator {
  bdf,             ///< variable-order BDF of SUNDIALS IDAS on (W, psi), Newton stage kernel
  backward_euler,  ///< adaptive, on the same stage kernel: the cross-check
};

struct RichardsProblem {
  meshes::Mesh mesh;                  ///< dim 1, 2 or 3
  meshes::Point gravity_direction{};  ///< unit vector, e.g. {-1} in one dimension
  double unit_weight = 9810;          ///< rho_l g [Pa/m]: turns psi into the pressures of the record
  std::vector<Soil> soils;            ///< one per mesh region
  std::vector<BoundaryCondition> boundary;
  std::vector<double> initial_head;  ///< psi at the mesh nodes [m]
  double end_time = 0;               ///< s
  std::vector<double> output_times;  ///< s, ascending, within [0, end_time]
  std::vector<Gauge> gauges;
  Integrator integrator = Integrator::bdf;
  double tolerance = 1e-6;  ///< relative tolerance of the integrator; absolute ones follow from it (README)
  int degree = 1;
};

/// The solver gave up; `partial` keeps everything computed until then and the message says where, when and why.
struct GaveUp : std::runtime_error {
  GaveUp(const std::string& message, meshes::FieldHistory kept)
      : std::runtime_error(message), partial(std::move(kept)) {}
  meshes::FieldHistory partial;
};

/// Solves the problem. Throws std::invalid_argument for a problem that makes no sense (which entry, why)
/// and GaveUp when no step size lets the nonlinear solver converge.
meshes::FieldHistory solve(const RichardsProblem& problem, meshes::Progress progress = nullptr);

}  // namespace wetfront::fem_reference
