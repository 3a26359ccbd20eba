#pragma once

#include "verification/exact/van_genuchten.h"

#include <array>
#include <variant>
#include <vector>

namespace wetfront::verification::exact {

/// A solution made up beforehand, and the source that makes it one, for Richards' equation with everything in it:
///   dW/dt = div(K(psi) T (grad psi - g)) + source,
///   psi = mean + sum_m a_m sin(k_m . x + w_m t + p_m)  < 0 everywhere: unsaturated, W = theta(psi).
/// With D = grad psi - g:  source = C psi_t - K' grad psi . T D - K T : grad grad psi, every derivative by hand.
/// Consistent units (SI where a solver is judged); g is the unit vector of gravity, T symmetric {xx, yy, zz, xy, yz,
/// zx}.
struct ManufacturedWave {
  double amplitude;
  std::array<double, 3> wave_vector;  ///< 1/m
  double frequency;                   ///< 1/s
  double phase;
};
/// K = Ks exp(alpha h), theta = theta_r + (theta_s - theta_r) exp(alpha h).
struct ManufacturedGardner {
  double theta_r, theta_s, alpha, conductivity;
};
struct Manufactured {
  std::variant<ManufacturedGardner, VanGenuchten> soil;
  std::array<double, 6> anisotropy{1, 1, 1, 0, 0, 0};
  std::array<double, 3> gravity{};  ///< g
  double mean;                      ///< m
  std::vector<ManufacturedWave> waves;
};

class ManufacturedSolution {
 public:
  using Point = std::array<double, 3>;
  /// std::invalid_argument unless mean + sum |a_m| < 0.
  explicit ManufacturedSolution(const Manufactured& problem);

  double head(const Point& at, double t) const;
  double source(const Point& at, double t) const;  ///< 1/s
  double content(double head) const;               ///< theta
  double conductivity(double head) const;          ///< K

 private:
  struct Law {
    double capacity, conductivity, slope;  ///< dtheta/dh, K, dK/dh
  };
  Law law(double head) const;
  Manufactured p_;
};

}  // namespace wetfront::verification::exact
