#pragma once

#include "verification/exact/van_genuchten.h"

namespace wetfront::verification::exact {

/// Steady vertical flow above a level of known head (Gardner 1958; Yeh 1989, WRR 25:2127): q = K(h)(dh/dz + 1), z up,
/// q downward positive (rain > 0, evaporation < 0). Layers are stacked by taking one's top head as the next base_head.

/// Gardner's soil K = Ks exp(alpha h): exp(alpha h) = q/Ks + (exp(alpha h0) - q/Ks) exp(-alpha z). Any consistent
/// units.
struct SteadyGardner {
  double alpha, conductivity;
  double flux;           ///< q <= Ks
  double base_head = 0;  ///< h0 <= 0 at z = 0

  /// h(z), z >= 0. std::invalid_argument unless q <= Ks, h0 <= 0, alpha, Ks > 0; std::domain_error for z < 0 or above
  /// the height to which evaporation can be drawn (where exp(alpha h) would turn negative).
  double head(double z) const;
};

/// van Genuchten's soil, by quadrature: z(h) = integral from h to h0 of dh'/(1 - q/K(h')).
class SteadyVanGenuchten {
 public:
  /// Rain or evaporation, q < Ks, above base_head <= 0. std::invalid_argument otherwise, and for rain that base_head
  /// cannot pass downwards unsaturated, i.e. K(base_head) < q (the profile would dry upwards towards K = q from below;
  /// not offered).
  SteadyVanGenuchten(const VanGenuchten& soil, double flux, double base_head = 0);

  /// Height where the head is h. std::domain_error outside (limit(), base_head].
  double height(double head) const;
  /// h(z), z >= 0, to 1e-10 of the range of heads. std::domain_error above max_height().
  double head(double z) const;
  /// Rain: the head K(h) = q, reached at infinite height. Evaporation or none: minus infinity.
  double limit() const { return limit_; }
  /// Rain or none: infinity. Evaporation: the height at which the head falls to -1e4/alpha.
  double max_height() const { return max_height_; }

 private:
  VanGenuchten soil_;
  double flux_, base_, limit_, max_height_;
};

}  // namespace wetfront::verification::exact
