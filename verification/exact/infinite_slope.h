#pragma once

namespace wetfront::verification::exact {

/// What acts on a plane parallel to the surface of an infinite slope: total stresses [Pa, compression positive], and
/// the pore pressure as it counts in the effective stress, chi p (suction < 0).
struct PlaneLoad {
  double normal, shear, pore = 0;
};
/// Angles in rad, cohesion in Pa.
struct PlaneStrength {
  double friction, dilatancy, cohesion;
};

/// Factors of safety, three ways. std::invalid_argument for shear <= 0 and angles outside (-pi/2, pi/2).
///
/// Limit equilibrium: (c' + sigma_n' tan phi')/tau. What slides on a plane that is given, or flows with psi = phi'.
double limit_safety(const PlaneLoad& load, const PlaneStrength& strength);
/// With Davis' strength (1968) of a soil that flows with psi: (c* + sigma_n' tan phi*)/tau; for psi = 0 sin phi' in
/// place of tan phi'.
double davis_safety(const PlaneLoad& load, const PlaneStrength& strength);
/// What strength reduction converges to: F at which Davis' strength of c'/F, tan phi'/F, tan psi/F equals tau. One
/// where Davis' factor is one, and further from one than that elsewhere (his reduction belongs to the reduced angles:
/// Tschuchnigg, Schweiger & Sloan 2015). 0 where nothing bears, infinity where no F <= 1e6 is too much.
double reduced_safety(const PlaneLoad& load, const PlaneStrength& strength);

}  // namespace wetfront::verification::exact
