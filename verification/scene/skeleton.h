#pragma once

#include "verification/scene/origin.h"

#include <array>
#include <optional>
#include <vector>

/// What a scene says of a skeleton that deforms: strength, the start, how its motion is discretised, what holds on
/// sides.
namespace wetfront::verification {

struct Elastic {
  double young, poisson;
  Origin origin;
};

/// Mohr-Coulomb; angles in rad.
struct FrictionalStrength {
  double friction = 0, cohesion = 0, dilatancy = 0;
  std::optional<double> tension_cut_off{};  ///< Pa; absent: the apex
};
/// What bounds the stress of the skeleton.
struct Strength {
  enum class Law { mohr_coulomb, softening, suction, cam_clay } law = Law::mohr_coulomb;
  FrictionalStrength peak;               ///< of all but Cam-Clay
  FrictionalStrength residual;           ///< softening
  double softening_range = 0;            ///< plastic shear strain at which the residual values are reached
  double suction_cohesion = 0;           ///< Pa; suction
  double cohesion_rate = 0;              ///< -
  double friction_rate = 0;              ///< rad
  double critical_slope = 0;             ///< M; Cam-Clay
  double compression = 0, swelling = 0;  ///< lambda, kappa
  double preconsolidation = 0;           ///< Pa
  Origin origin;
};

/// [skeleton]: how it starts and how its motion is discretised.
struct SkeletonSettings {
  bool k0_stress = false;  ///< initial stress by the K_0 procedure; else zero
  enum class Shape { linear, quadratic_spline } shape = Shape::linear;
  enum class Update { musl, usf, usl } update = Update::musl;
  bool apic = false;  ///< else FLIP with a share `pic`
  double pic = 0;
  bool b_bar = true;
  enum class Integration { automatic, mixed, points } integration = Integration::automatic;  ///< of stress
  Origin origin;
};

/// What the skeleton meets on a side, besides a load.
struct SkeletonCondition {
  enum class Kind { free, fixed, moving, contact, absorbing, periodic } kind = Kind::free;
  std::array<bool, 3> axes{};        ///< fixed or moving
  std::array<double, 3> velocity{};  ///< m/s; moving
  double friction = 0;               ///< tan(delta); contact
};

/// How a stage lets the skeleton move.
struct SkeletonMotion {
  bool quasi_static = false;
  double unbalanced_ratio = 2e-4, relaxation_damping = 0.7;
  double coupling_tolerance = 1e-6;  ///< of flow and skeleton, relative pressure
};

/// What may end a stage before its latest time.
struct StageEvent {
  enum class Kind { none, failure, rest } kind = Kind::none;
  double displacement = 0, unbalanced_ratio = 0, shortest_step = 0;  ///< failure: m, -, s
  double energy_ratio = 0, hold = 0;                                 ///< rest: -, s
};

}  // namespace wetfront::verification
