#pragma once

#include "meshes/field_history.h"
#include "meshes/mesh.h"
#include "meshes/rain_record.h"

#include <array>
#include <functional>
#include <optional>
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
  /// Shape of the conductivity tensor: K = Ks Kr(psi) T, T symmetric and positive definite, {xx, yy, zz, xy, yz, zx}.
  std::array<double, 6> anisotropy{1, 1, 1, 0, 0, 0};
  /// Storage of an elastic skeleton under constant total stress: W gains the integral of S (chi + p dchi/dp) / E_oed
  /// over the pore pressure p, chi Bishop's parameter. 0: rigid.
  double oedometer_modulus = 0;  ///< E_oed [Pa]
  enum class Bishop { saturation, effective_saturation } bishop = Bishop::saturation;
};

/// T of principal values: the first along x, the second (two dimensions) or third (three) along the elevation axis,
/// then turned by `angle` [rad] in that vertical plane, anticlockwise with x to the right and the elevation up.
std::array<double, 6> principal_tensor(int dim, const std::array<double, 3>& values, double angle);

/// Piecewise linear in time, constant before the first and after the last entry; two entries at one time are a jump.
/// Empty: not given.
struct TimeRecord {
  std::vector<double> time;   ///< s, not falling
  std::vector<double> value;  ///< as the owner says
};

/// Rain per horizontal area; what the soil does not take runs off (psi <= 0 complementary to run-off >= 0).
/// A record without rain makes the side a seepage face. Evaporation, per horizontal area too, is met in full while
/// psi > minimum_head, in part while psi = minimum_head, and not at all below (complementarity as at the wet end).
struct RainSide {
  std::string side;
  meshes::RainRecord rain;
  meshes::RainRecord evaporation{};  ///< demand [m/s, >= 0]; empty: none
  double minimum_head = -150;        ///< m; of evaporation only
};
/// Water offered (> 0) to or demanded (< 0) from a side per area of it, whatever way it faces; limited as rain and
/// evaporation are.
struct FluxSide {
  std::string side;
  meshes::RainRecord inflow;   ///< m/s, of either sign
  double minimum_head = -150;  ///< m
};
struct HeadSide {
  std::string side;
  double head;           ///< prescribed psi, or psi + elevation where `total` [m]
  TimeRecord record{};   ///< the same in time, instead of `head`
  bool total = false;    ///< the head includes the elevation: hydrostatic along the side
  bool initial = false;  ///< psi stays what initial_head says, node by node, instead of `head`
  /// psi at a place and a time [m, s], smooth in time, instead of `head`: for closed forms and manufactured solutions.
  std::function<double(const meshes::Point&, double)> varying{};
};
/// A free water surface in front of the side: hydrostatic below it (psi = level - elevation, water passes both ways),
/// rain or seepage face above. Rain on what is under water belongs to the water body.
struct WaterLevelSide {
  std::string side;
  TimeRecord level;           ///< elevation of the surface [m]
  meshes::RainRecord rain{};  ///< per horizontal area
};
/// What leaves through `side` comes in through `partner`, which is `side` moved by one vector, node by node.
struct PeriodicSides {
  std::string side;
  std::string partner;
};
/// Unit gradient of total head: water leaves at K(psi).
struct FreeDrainageSide {
  std::string side;
};
/// A side without one is impermeable. Where sides meet a head wins over a water level, and that over rain.
using BoundaryCondition = std::variant<RainSide, HeadSide, FreeDrainageSide, FluxSide, WaterLevelSide, PeriodicSides>;

struct Gauge {
  std::string name;
  meshes::Point position;
};

enum class Integrator {
  bdf,             ///< variable-order BDF of SUNDIALS IDAS on (W, psi), Newton stage kernel
  backward_euler,  ///< adaptive, on the same stage kernel: the cross-check
  dirk,            ///< diagonally implicit Runge-Kutta of SUNDIALS ARKStep, stiffly accurate, same stage kernel
};

/// Mesh refinement towards wetting fronts (two and three dimensions; `mesh` is the coarsest mesh there is).
struct Adaptivity {
  int levels = 2;  ///< halvings of the cells of `mesh` at most; the record is on `mesh` halved that often
  /// A cell is halved where the indicator (README) exceeds this water content [-], and joined below a fraction of it.
  double threshold = 1e-3;
};

struct RichardsProblem {
  meshes::Mesh mesh;                          ///< dim 1, 2 or 3
  meshes::Point gravity_direction{};          ///< unit vector, e.g. {-1} in one dimension
  double unit_weight = 9810;                  ///< rho_l g [Pa/m]: turns psi into the pressures of the record
  std::vector<Soil> soils;                    ///< one per mesh region
  std::vector<double> conductivity_factor{};  ///< per mesh cell, times its soil's Ks [-]; empty: 1
  std::vector<BoundaryCondition> boundary;
  std::vector<double> initial_head;  ///< psi at the mesh nodes [m]
  double end_time = 0;               ///< s
  std::vector<double> output_times;  ///< s, ascending, within [0, end_time]
  std::vector<Gauge> gauges;
  Integrator integrator = Integrator::bdf;
  double tolerance = 1e-6;  ///< relative tolerance of the integrator; absolute ones follow from it (README)
  int degree = 1;
  std::optional<Adaptivity> adaptivity{};  ///< absent: the mesh stays
  /// Water that comes up inside the soil [1/s] at a place and a time: for manufactured solutions.
  std::function<double(const meshes::Point&, double)> source{};
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

/// psi at the mesh nodes [m] of the steady state under what holds at t = 0 (records and `varying` at 0), started from
/// initial_head; output times, end time and integrator do not matter. Throws as solve().
std::vector<double> steady_head(const RichardsProblem& problem);

}  // namespace wetfront::fem_reference
