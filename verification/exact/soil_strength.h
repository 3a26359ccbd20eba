#pragma once

namespace wetfront::verification::exact {

/// Closed forms of perfectly plastic soil after Mohr and Coulomb. Angles in rad, stresses in Pa, compression positive
/// HERE (as strengths are usually given); std::invalid_argument for angles outside [0, pi/2).

/// sigma_1 at failure in triaxial compression under sigma_3: N sigma_3 + 2 c sqrt(N), N = tan^2(pi/4 + phi/2).
double triaxial_strength(double friction, double cohesion, double confinement);
/// q/p' at failure in compression, 6 sin phi/(3 - sin phi), and in extension, 6 sin phi/(3 + sin phi); c = 0.
double critical_slope_compression(double friction);
double critical_slope_extension(double friction);

/// tan of the friction angle that a plane with coaxial flow of dilatancy psi can bear (Davis 1968):
/// cos psi sin phi/(1 - sin psi sin phi): tan phi for psi = phi, sin phi for psi = 0. Simple shear, infinite slopes.
double davis_friction(double friction, double dilatancy);
/// The same factor on cohesion: cos psi cos phi/(1 - sin psi sin phi) c.
double davis_cohesion(double friction, double dilatancy, double cohesion);
/// Factor of safety of a dry infinite slope of unit weight gamma, `depth` measured vertically. cohesion 0: any depth.
struct DrySlope {
  double slope;  ///< angle [rad]
  double friction, dilatancy;
  double cohesion = 0, unit_weight = 1, depth = 1;
};
double safety_of(const DrySlope& slope);

/// Prandtl 1921 and Reissner 1924, weightless soil under a smooth strip: q_f = c N_c + q_0 N_q,
/// N_q = exp(pi tan phi) tan^2(pi/4 + phi/2), N_c = (N_q - 1)/tan phi, pi + 2 for phi = 0. Exact for associated flow.
double bearing_factor_surcharge(double friction);
double bearing_factor_cohesion(double friction);

/// A rigid block on a plane of slope beta with friction mu, released at rest: g (sin beta - mu cos beta), 0 where it
/// sticks.
double sliding_acceleration(double slope, double friction_coefficient, double gravity);

/// Modified Cam-Clay (Roscoe & Burland 1968; Wood 1990, section 5): undrained triaxial compression of a normally
/// consolidated sample of mean stress p0 ends at p' = p0 2^-(1 - kappa/lambda), q = M p'.
double cam_clay_undrained_mean_stress(double p0, double compression, double swelling);

}  // namespace wetfront::verification::exact
