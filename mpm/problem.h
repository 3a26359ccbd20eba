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
  double air_entry;     ///< p0 [Pa]
  double lambda;        ///< -
  double s_min, s_max;  ///< least and largest degree of saturation [-]
  /// Saturated down to this suction [Pa], S_e = S_e,vG / S_e,vG(cut_off) beyond, Mualem's integral cut at the same
  /// place (Vogel, van Genuchten & Cislerova 2001; Ippisch, Vogel & Bastian 2006). 0: none.
  double cut_off = 0;
};
/// Gardner: S = S_min + (S_max - S_min) exp(-s / p_c) for s > 0.
struct ExponentialRetention {
  double suction_scale;  ///< p_c [Pa]
  double s_min, s_max;   ///< least and largest degree of saturation [-]
};
/// Haverkamp et al. 1977, sand; Vauclin et al. 1979: S_e = a / (a + s^beta), s in Pa.
struct HaverkampRetention {
  double a;             ///< Pa^beta
  double beta;          ///< -
  double s_min, s_max;  ///< least and largest degree of saturation [-]
};
/// Haverkamp et al. 1977, Yolo clay: S_e = a / (a + ln(s / entry)^beta) for s > entry, else 1.
struct HaverkampLogRetention {
  double a;             ///< -
  double beta;          ///< -
  double entry;         ///< the unit of length in the logarithm, as suction [Pa]
  double s_min, s_max;  ///< least and largest degree of saturation [-]
};
/// Broadbridge & White 1988: -s / scale = 1 - 1/S_e - ln[(c - S_e) / ((c - 1) S_e)] / c.
struct BroadbridgeWhiteRetention {
  double c;              ///< > 1
  double suction_scale;  ///< lambda_s rho g [Pa]
  double s_min, s_max;   ///< least and largest degree of saturation [-]
};
/// Measured points, interpolated monotonely with a continuous slope; constant beyond the driest.
struct PointsRetention {
  std::vector<double> suction;     ///< Pa, ascending, the first is 0
  std::vector<double> saturation;  ///< -, not rising; the first is S_max
};
using RetentionSpec = std::variant<VanGenuchtenRetention, ExponentialRetention, HaverkampRetention,
                                   HaverkampLogRetention, BroadbridgeWhiteRetention, PointsRetention>;

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
/// Haverkamp et al. 1977, Vauclin et al. 1979: k_rel = a / (a + s^gamma), s in Pa.
struct HaverkampPermeability {
  double a;      ///< Pa^gamma
  double gamma;  ///< -
};
/// Broadbridge & White 1988: k_rel = (c - 1) S_e^2 / (c - S_e), with their retention curve.
struct BroadbridgeWhitePermeability {};
/// ln k_rel interpolated as PointsRetention.
struct PointsPermeability {
  std::vector<double> suction;   ///< Pa, ascending, the first is 0
  std::vector<double> relative;  ///< -, positive, not rising; the first is 1
};
using PermeabilitySpec =
    std::variant<MualemPermeability, PrintedMualemPermeability, MualemOfSaturationPermeability, ExponentialPermeability,
                 ConstantPermeability, HaverkampPermeability, BroadbridgeWhitePermeability, PointsPermeability>;

/// Bishop's parameter chi of sigma' = sigma + chi p: the degree of saturation, or the effective one.
enum class Bishop { saturation, effective_saturation };

/// Linear isotropic elasticity of the skeleton (effective stress).
struct Elastic {
  double young;    ///< Pa
  double poisson;  ///< -
  Origin origin;
};

/// Friction and cohesion; perfectly plastic, non-associated where dilatancy differs from friction.
struct MohrCoulomb {
  double friction;   ///< phi' [rad]
  double cohesion;   ///< c' [Pa]
  double dilatancy;  ///< psi [rad]
  /// Largest tensile principal stress [Pa, >= 0]; not given: the apex, c' cot phi'.
  std::optional<double> tension_cut_off{};
  Origin origin;
};
/// Friction, cohesion and dilatancy fall from peak to residual with the plastic shear strain
/// (gamma_p = int sqrt(2/3 e_p:e_p)): linearly until `range`.
struct SofteningMohrCoulomb {
  MohrCoulomb peak, residual;
  double range;  ///< plastic shear strain at which the residual values are reached [-]
};
/// Yerro, Alonso & Pinyol 2015: c = c' + c_max (1 - exp(-B s/p_atm)), phi = phi' + A s/p_atm, with suction s.
struct SuctionMohrCoulomb {
  MohrCoulomb saturated;
  double suction_cohesion;  ///< c_max [Pa]
  double cohesion_rate;     ///< B [-]
  double friction_rate;     ///< A [rad]
};
/// Modified Cam-Clay (Roscoe & Burland 1968); elastic.poisson holds, elastic.young is not used.
struct ModifiedCamClay {
  double critical_slope;         ///< M [-]
  double compression;            ///< lambda, of ln p' [-]
  double swelling;               ///< kappa [-]
  double void_ratio;             ///< e at the start [-]
  double preconsolidation;       ///< p_c > 0 [Pa]
  double least_pressure = 1000;  ///< mean effective stress below which stiffness is kept [Pa]
  Origin origin;
};
/// P = lambda ln J F^-T + mu (F - F^-T), lambda and mu from `Elastic`: for verification at finite strain.
struct NeoHookean {
  Origin origin;
};
/// Kirchhoff stress linear in the logarithmic strain (Hencky), for verification at finite strain.
struct Hencky {
  Origin origin;
};
/// What limits or replaces linear elasticity in increments.
using SkeletonLaw =
    std::variant<MohrCoulomb, SofteningMohrCoulomb, SuctionMohrCoulomb, ModifiedCamClay, NeoHookean, Hencky>;

struct Soil {
  std::string name;
  double porosity;                               ///< n at the start, pores over volume [-]
  double grain_density;                          ///< kg/m3
  double intrinsic_permeability;                 ///< m2
  std::optional<RetentionSpec> retention;        ///< absent in a dry scene
  std::optional<PermeabilitySpec> permeability;  ///< absent in a dry scene
  std::optional<Elastic> elastic;                ///< absent: rigid skeleton
  Origin origin;
  /// Shape of the permeability tensor: k T, T symmetric and positive definite, {xx, yy, zz, xy, yz, zx}.
  std::array<double, 6> anisotropy{1, 1, 1, 0, 0, 0};
  /// Volume of water stored per volume of saturated soil and pressure [1/Pa], in place of n S_max / K_l.
  std::optional<double> storage{};
  Bishop bishop = Bishop::saturation;
  /// With `elastic` only; absent: linear elasticity.
  std::optional<SkeletonLaw> law{};
  /// K_0 = sigma'_h/sigma'_v of the initial stress where the problem asks for it; absent: nu/(1-nu).
  std::optional<double> earth_pressure_at_rest{};
};
/// Whether the soil's strength needs the suction of its points.
inline bool strengthened_by_suction(const Soil& soil) {
  return soil.law && std::holds_alternative<SuctionMohrCoulomb>(*soil.law);
}

/// Piecewise linear in time, constant before the first and after the last entry; two entries at one time are a jump.
/// Schemes step exactly onto every time. Empty: not given.
struct TimeRecord {
  std::vector<double> time;   ///< s, not falling
  std::vector<double> value;  ///< in the unit of what it prescribes
};

/// Names the surface of the body wherever it is, also inside cells (Problem::surface), in place of a side of the mesh:
/// the faces and cuts that separate soil from empty space, detected anew whenever points have moved.
inline const std::string free_surface = "free surface";

/// Rain per horizontal area on a side; what the soil does not take runs off. A record without rain is a
/// potential seepage face. Evaporation, per horizontal area too, is met in full while p > least_pressure, in part at
/// it, not at all below.
struct RainSide {
  std::string side;
  meshes::RainRecord rain;
  Origin origin;
  meshes::RainRecord evaporation{};  ///< demand [m/s, >= 0]; empty: none
  double least_pressure = -1.5e6;    ///< Pa; of evaporation only
};
struct PressureSide {
  std::string side;
  double pressure;  ///< Pa
  Origin origin;
  TimeRecord record{};   ///< the same in time [Pa], instead of `pressure`
  bool initial = false;  ///< stays what initial_pressure says, node by node, instead of `pressure`
};
/// p = rho |g| (head - elevation): hydrostatic along the side.
struct TotalHeadSide {
  std::string side;
  TimeRecord head;  ///< m
  Origin origin;
};
/// A free water surface in front of the side: hydrostatic below it (water passes both ways), rain or seepage face
/// above. Rain on what is under water belongs to the water body.
struct WaterLevelSide {
  std::string side;
  TimeRecord level;           ///< elevation of the surface [m]
  meshes::RainRecord rain{};  ///< per horizontal area
  Origin origin;
};
/// Water offered (> 0) to or demanded (< 0) from a side per area of it, limited as rain and evaporation are.
struct FluxSide {
  std::string side;
  meshes::RainRecord inflow;       ///< m/s, of either sign
  double least_pressure = -1.5e6;  ///< Pa; of the demand only
  Origin origin;
};
/// Unit gradient of total head: water leaves at K(p).
struct FreeDrainageSide {
  std::string side;
  Origin origin;
};
/// What leaves through `side` comes in through `partner`, which is `side` moved by one vector, node by node.
struct PeriodicSides {
  std::string side, partner;
  Origin origin;
};
/// A side without one is impermeable. Where sides meet a held pressure wins over a water level, and that over rain.
using WaterBoundary =
    std::variant<RainSide, PressureSide, FreeDrainageSide, TotalHeadSide, WaterLevelSide, FluxSide, PeriodicSides>;

/// Skeleton fixed on a side: per axis, true = no displacement along that axis.
struct Fixity {
  std::string side;
  std::array<bool, 3> fixed{};
  Origin origin;
};

/// Force per area on a side of the mesh or on the `free_surface`: `pressure` pushes against the outward normal, `force`
/// is a vector. Each is multiplied by `factor` in time; no factor: 1.
struct Traction {
  std::string side;
  double pressure = 0;            ///< Pa, compression-positive
  std::array<double, 3> force{};  ///< Pa
  TimeRecord factor{};
  Origin origin;
};
/// A velocity given to the skeleton on a side, per axis; axes without one are free.
struct MovingSide {
  std::string side;
  std::array<std::optional<double>, 3> velocity{};  ///< m/s
  TimeRecord factor{};
  Origin origin;
};
/// A rigid base on which the body may slide and from which it may lift: Coulomb friction mu = tan(delta) on the
/// effective normal reaction. Several sides may form one base: nodes at their corners take both normals.
struct FrictionalContact {
  std::string side;
  double friction;  ///< mu [-]
  Origin origin;
};
/// Lysmer & Kuhlemeyer 1969: waves leave; tractions rho c v against the motion.
struct AbsorbingSide {
  std::string side;
  Origin origin;
};
/// The skeleton's side and its partner (the same, moved by one vector, node by node) move as one.
struct PeriodicSkeleton {
  std::string side, partner;
  Origin origin;
};
using SkeletonBoundary = std::variant<Traction, MovingSide, FrictionalContact, AbsorbingSide, PeriodicSkeleton>;

/// How the stress of the beginning is found.
enum class InitialStress {
  none,  ///< zero effective stress
  k0,    ///< vertical stress of what lies above, horizontal K_0 of it (K_0 procedure)
};

/// Shape functions of the skeleton's motion.
enum class ShapeFunctions {
  linear,            ///< of the mesh's quadrilaterals and hexahedra
  quadratic_spline,  ///< B-splines on a Cartesian grid (Steffen, Kirby & Berzins 2008): no cell-crossing noise
};
/// When stress is updated in a step.
enum class StressUpdate {
  musl,  ///< after the points' momenta have been mapped back (Sulsky, Zhou & Schreyer 1995; the paper's steps I to IX)
  usf,   ///< first, with the velocities at the start of the step (Bardenhagen 2002)
  usl,   ///< last, with the nodes' own velocities
};
/// How velocities pass between nodes and points.
enum class Transfer {
  flip,  ///< increments; with a share `pic` of the nodes' velocities themselves
  apic,  ///< affine particle-in-cell (Jiang et al. 2015)
};
enum class LockingRemedy {
  b_bar,  ///< volumetric strain and mean stress act with the cell's mean gradient (Hughes 1980)
  none,
};
/// Where the stress of the skeleton is integrated.
enum class StressIntegration {
  mixed,   ///< cells inside a body: the points' mean stress over the cell's own volume, the rest at the points
  points,  ///< at the points alone, with their volumes: forces jump whenever a point crosses a cell
};
/// How the motion of the skeleton is discretised.
struct SkeletonScheme {
  ShapeFunctions shape = ShapeFunctions::linear;
  StressUpdate update = StressUpdate::musl;
  Transfer transfer = Transfer::flip;
  double pic = 0;  ///< share of PIC in each step's FLIP update, 0 to 1 [-]
  LockingRemedy locking = LockingRemedy::b_bar;
  /// Absent: mixed in stages without liquid; at the points with it, whose pressure follows the points' volumes.
  std::optional<StressIntegration> integration{};

  StressIntegration integration_of(bool with_liquid) const {
    return integration.value_or(with_liquid ? StressIntegration::points : StressIntegration::mixed);
  }
};

struct Probe {
  std::string name;
  meshes::Point position{};
  Origin origin;
};

/// How the pore liquid moves in a stage: the ladder of schemes, from the cheapest to the most literal.
enum class LiquidScheme {
  seepage,        ///< no inertia, implicit on the grid: backward Euler or BDF2 with error control
  semi_implicit,  ///< inertia of the liquid at the points, pressure and drag implicit on the grid
  implicit_drag,  ///< two velocities, momentum balances, drag implicit per node (Lee 2021 with Eq. 4/18 corrected)
  explicit_drag,  ///< the same with explicit drag, as the paper: steps of microseconds, to verify the others
};
enum class TimeIntegrator { bdf2, backward_euler };  ///< of `seepage`
/// Liquid mass balance of the two-velocity schemes.
enum class MassBalance {
  conservative,  ///< d(n S rho)/dt = -div(rho n S (v_l - v_s)) - rho n S div v_s
  printed_2021,  ///< Eqs 4/18 of Lee et al. 2021 as printed: loses (v_l - v_s).grad(nS). A research variant
};
/// Where rain enters: `standard` knows where in a cell the surface lies; the others are named variants for research.
enum class RainScheme {
  standard,         ///< mpm/README.md section 5, mpm/two_velocity/README.md section 5
  martinelli_2020,  ///< all of it at the nodes outside, wherever the surface lies between them and the next
  bandara_2016,     ///< into the boundary points of the surface cells
  consistent_flux,  ///< integral of N_i over the surface as a source of the nodes
};

/// How a deforming skeleton moves in a stage.
enum class SkeletonMotion {
  dynamic,       ///< in true time, with inertia
  quasi_static,  ///< from equilibrium to equilibrium: damped relaxation after each step of the liquid or of the load
};
/// When relaxation is over, and when it has failed.
struct Relaxation {
  double unbalanced_ratio = 2e-4;  ///< |out-of-balance force| / |forces| below which a state is an equilibrium
  long most_iterations = 6000;     ///< times the cells along the body's longest axis over 100; beyond it the run stops
  double damping = 0.7;            ///< local (Cundall)
  double coupling_tolerance = 1e-6;  ///< of the split between flow and skeleton, relative
};

/// What may end a stage before its end time.
enum class StageEnd {
  time,
  failure,  ///< quasi-static: the skeleton finds no equilibrium any more; the last one is restored
  rest,     ///< dynamic: the body has come to rest
};
/// A skeleton has failed when, with the step of the liquid shrunk to `shortest_step`, a twentieth of its nodes have
/// moved by more than `displacement` since the step began (one node, a corner with a sliver of soil, says nothing), or
/// a relaxation ends (at Relaxation::most_iterations, which grows with length over cell size) with more than
/// `unbalanced_ratio` out of balance. One that ends there with less has only stalled.
struct FailureCriterion {
  double displacement = 0.02;      ///< m
  double unbalanced_ratio = 5e-3;  ///< -
  double shortest_step = 2;        ///< s: the time of failure is known to this
};
/// At rest: for `hold` no kinetic energy above `energy_ratio` times the largest of the stage (or, where the body never
/// moved faster than `slowest` in the mean, above the energy of that).
struct RestCriterion {
  double energy_ratio = 1e-3;  ///< -
  double hold = 0.2;           ///< s
  double slowest = 1e-3;       ///< m/s
};

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
  SkeletonMotion motion = SkeletonMotion::dynamic;  ///< of soils with `elastic`
  Relaxation relaxation{};
  StageEnd ends_with = StageEnd::time;  ///< `end_time` is the latest
  double longest = 0;                   ///< s: ends so long after its own beginning at the latest; 0: at `end_time`
  FailureCriterion failure{};
  RestCriterion rest{};
  double picture_every = 0;  ///< s between snapshots for BodyRecord::pictures; 0: none
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
  /// Two dimensions: the line below which there is soil, from left to right [m]; cells above it are empty, cells it
  /// cuts are partly filled. Empty: every cell is full.
  std::vector<meshes::Point> surface{};
  std::vector<char> empty_cells{};            ///< per mesh cell: 1 where there is no soil at the start; empty: none
  std::vector<double> conductivity_factor{};  ///< per mesh cell, times its soil's permeability [-]; empty: 1
  std::vector<WaterBoundary> water_boundary;
  std::vector<Fixity> fixities;
  std::vector<SkeletonBoundary> skeleton_boundary{};
  SkeletonScheme skeleton{};
  InitialStress initial_stress = InitialStress::none;
  /// Velocity of the skeleton at a place when the run begins [m/s]; empty: at rest.
  std::function<std::array<double, dim>(const std::array<double, dim>&)> initial_velocity{};
  /// Acceleration [m/s2] of the point that began at X, at a time: for manufactured solutions. Points remember X for it.
  std::function<std::array<double, dim>(const std::array<double, dim>&, double)> body_acceleration{};
  int threads = 1;  ///< of the kernels over cells; results do not depend on it
  std::vector<Probe> probes;
  std::vector<Probe> riders{};  ///< followed from their first places: BodyRecord::riders
  int points_per_cell = 4;      ///< of full cells at the start
  RainScheme rain_scheme = RainScheme::standard;
  /// CPU seconds that a run may take; a plan that expects more is refused, a run that takes more gives up. 0: any.
  double cpu_budget = 0;
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
