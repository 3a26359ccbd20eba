#pragma once

namespace wetfront::verification::exact {

/// Terzaghi 1923, one-dimensional consolidation of a layer of thickness H drained at the top, closed at the base, under
/// a load sigma put on at t = 0. Z = depth/H from the drained top in [0, 1], T = c_v t/H^2:
///   p/p0 = sum (2/M) sin(M Z) exp(-M^2 T),  U = 1 - sum (2/M^2) exp(-M^2 T),  M = (2k + 1) pi/2.
/// Below T = 0.2 the same solution by images (erfc), which converges there; both are exact to about 1e-15 absolute.
/// std::domain_error for T < 0 or Z outside [0, 1].
double terzaghi_pressure(double depth_ratio, double time_factor);  ///< p/p0; at T = 0: 1, but 0 on the drained top
double terzaghi_degree(double time_factor);                        ///< U, settled fraction
/// T at which U is reached, 0 <= U < 1; std::domain_error outside.
double terzaghi_time_factor(double degree);

/// The same with water of finite stiffness (Verruijt 2013; skeleton linear elastic, oedometer modulus M_oed = 1/m_v):
///   c_v = k/(gamma_w (m_v + n/K_w)),  p0 = sigma/(1 + n/(K_w m_v)). SI units; p and sigma compression-positive.
struct Terzaghi {
  double thickness;          ///< H [m]
  double permeability;       ///< k [m/s]
  double unit_weight_water;  ///< gamma_w [N/m^3]
  double oedometer_modulus;  ///< 1/m_v [Pa]
  double load;               ///< sigma [Pa]
  double porosity = 0;       ///< n; 0 with any water_modulus: incompressible water
  double water_modulus = 1;  ///< K_w [Pa]; only n/K_w enters
};

/// std::invalid_argument for non-positive parameters or a porosity outside [0, 1).
class TerzaghiSolution {
 public:
  explicit TerzaghiSolution(const Terzaghi& problem);
  double consolidation_coefficient() const { return cv_; }  ///< c_v [m^2/s]
  double initial_pressure() const { return p0_; }           ///< p0 [Pa]
  double pressure(double depth, double t) const;            ///< excess pore pressure [Pa], depth from the drained top
  double settlement(double t) const;                        ///< of the top, downward positive [m]

 private:
  Terzaghi p_;
  double cv_, p0_;
};

}  // namespace wetfront::verification::exact
