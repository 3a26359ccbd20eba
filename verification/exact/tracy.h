#pragma once

#include <vector>

namespace wetfront::verification::exact {

/// Tracy 2006 (WRR 42 W08503): a box [0, a] (x [0, b]) x [0, L], z up, Gardner's soil K = Ks exp(alpha h),
/// theta = theta_r + (theta_s - theta_r) exp(alpha h), at h = dry_head until t = 0, when the top is wetted. SI units.
/// h = (1/alpha) ln(exp(alpha hr) + H), h0 = 1 - exp(alpha hr), c = alpha (theta_s - theta_r)/Ks; H solves the linear
/// equation laplace(H) + alpha H_z = c H_t and is a sum over the lateral modes of the top,
///   H = h0 sum_m w_m phi_m(x, y) T(kappa_m^2; z, t),
///   T = exp(alpha (L - z)/2) [ sinh(b z)/sinh(b L) + 2/(L c) sum_k (-1)^k (l_k/g_k) sin(l_k z) exp(-g_k t) ],
///   l_k = k pi/L, b^2 = alpha^2/4 + kappa^2, g_k = (b^2 + l_k^2)/c.
/// The bottom is held at dry_head; the sides at dry_head (specified) or closed (no flux).
struct Tracy {
  /// specified: sides at dry_head, top H = h0 sin(pi x/a) [sin(pi y/b)].
  /// closed: no flux through the sides, top H = h0 (1 - cos(2 pi x/a))/2 [(1 - cos(2 pi y/b))/2].
  enum class Sides { specified, closed };

  double alpha;         ///< 1/m
  double conductivity;  ///< Ks [m/s]
  double theta_r, theta_s;
  double dry_head;     ///< hr < 0 [m]
  double width;        ///< a [m]
  double depth_y = 0;  ///< b [m]; 0: two dimensions, y is ignored
  double height;       ///< L [m]
  Sides sides = Sides::specified;
};

/// The top's head is incompatible with the initial one at t = 0; `terms` bounds how early the solution may be asked.
/// Throws std::invalid_argument for non-positive sizes or dry_head >= 0; std::domain_error for t < 0, a point outside
/// the box, or fewer than 8 digits (t too small for `terms`, or cancellation: very dry soil in a box many 1/alpha
/// high).
class TracySolution {
 public:
  explicit TracySolution(const Tracy& problem, int terms = 2000);

  double head(double x, double z, double t) const { return head(x, 0, z, t); }
  double head(double x, double y, double z, double t) const;  ///< m; t = infinity gives the steady state
  double steady_head(double x, double y, double z) const;     ///< m

 private:
  struct LateralMode {
    double weight, kx, ky;  ///< phi = sin or cos of kx x and ky y, as the sides say
  };
  double vertical(double kappa_squared, double z, double t, double background) const;
  double lateral(const LateralMode& mode, double x, double y) const;
  Tracy p_;
  int terms_;
  double dry_, rise_, c_;  ///< exp(alpha hr), h0, c [s/m^2]
  std::vector<LateralMode> modes_;
};

}  // namespace wetfront::verification::exact
