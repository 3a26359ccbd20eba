#pragma once

namespace wetfront::verification::exact {

/// Iverson 2000 (WRR 36:1897-1910): pressure response of wet ground on an infinite slope to rain of intensity I and
/// duration T, Z vertical DOWN from the surface, water table at depth d:
///   psi/Z = beta (1 - d/Z) + (I/Kz) [R(t*) - R(t* - T*)],  R(t*) = sqrt(t*/pi) exp(-1/t*) - erfc(1/sqrt t*),
///   t* = t D/Z^2, D = 4 D0 cos^2 alpha, beta = cos^2 alpha (slope-parallel flow) less the background Iz/Kz.
/// The response obeys psi_t = D0 cos^2 alpha psi_ZZ, -psi_Z = I/Kz at Z = 0 while it rains. Linear diffusion without a
/// limit at psi = beta Z: long rain drives psi beyond the load of a water column (Iverson 2000, section 3.2; use
/// `exceeds_beta_line`). SI units.
struct Iverson {
  double slope_angle;         ///< alpha [rad], in (0, pi/2)
  double diffusivity;         ///< D0 [m^2/s]
  double relative_intensity;  ///< I/Kz
  double duration;            ///< T [s]
  double water_table;         ///< d [m]
  double background = 0;      ///< steady Iz/Kz: beta = cos^2 alpha - Iz/Kz
};

/// Infinite-slope strength (Iverson 2000 eq 28), effective friction and cohesion.
struct SlopeStrength {
  double friction_angle;     ///< phi [rad]
  double cohesion;           ///< c [Pa]
  double unit_weight_soil;   ///< gamma_s [N/m^3]
  double unit_weight_water;  ///< gamma_w [N/m^3]
};

/// FS = tan phi/tan alpha + (c - psi gamma_w tan phi)/(gamma_s Z sin alpha cos alpha), Z > 0 vertical [m], psi [m]
/// (suction psi < 0 adds strength in full, as in that paper). std::domain_error for Z <= 0, std::invalid_argument for
/// alpha outside (0, pi/2).
double infinite_slope_safety(const SlopeStrength& strength, double slope_angle, double depth, double head);

/// R(t*) of Iverson's eq 27e; 0 for t* <= 0.
double iverson_response(double normalised_time);

/// std::invalid_argument for an angle outside (0, pi/2), D0 <= 0, negative intensity or duration.
class IversonSolution {
 public:
  explicit IversonSolution(const Iverson& problem);
  /// psi [m] at vertical depth Z >= 0 [m], t >= 0 [s]. std::domain_error otherwise.
  double head(double depth, double t) const;
  /// True where psi > beta Z, which no rain can cause: the solution has left its physical range.
  bool exceeds_beta_line(double depth, double t) const;

 private:
  double transient(double depth, double t) const;
  Iverson p_;
  double beta_, diffusion_;  ///< diffusion_ = D0 cos^2 alpha
};

}  // namespace wetfront::verification::exact
