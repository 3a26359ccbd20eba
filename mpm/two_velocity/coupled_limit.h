#pragma once

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

/// The stiffest motion of a cell of skeleton and liquid together, as two degrees of freedom: the displacement of the
/// skeleton and that of the liquid against it (README.md section 6b),
///
///   M = [rho_m, m; m, m]   m = nS rho_l,  rho_m = (1-n) rho_s + m      D = [0, 0; 0, m r]
///   K = [k_s E_oed + k_p S^2/C, k_p S nS/C; k_p S nS/C, k_p (nS)^2/C]
///
/// A mode of the symplectic step leaves the unit circle through -1, where 4 M s^2 +- 2 D s - K is singular, s = 1/dt;
/// + where the drag is implicit, - where it is explicit. Stable: positive semi-definite.
struct CoupledCell {
  double mixture = 0, liquid = 0;    ///< rho_m, m [kg/m3]
  double k11 = 0, k12 = 0, k22 = 0;  ///< [Pa/m2]
  double drag = 0;                   ///< +r (implicit), -r (explicit) [1/s]

  /// The cell is stable with steps 1/s.
  bool stable(double s) const {
    const double square = 4 * s * s, a = mixture * square - k11;
    const double b = liquid * (square + 2 * drag * s) - k22, c = liquid * square - k12;
    return a >= 0 && b >= 0 && a * b >= c * c;
  }
  /// The largest s at which it is not: Newton's method on the determinant from above. All four roots are real (the
  /// problem is hyperbolic: D^2 + 16 M K > 0), so that it falls to the largest without passing it.
  double critical() const {
    const double reduced = liquid * (mixture - liquid);
    const double trace = (liquid * (k11 - 2 * k12) + mixture * k22) / reduced;
    const double rate = std::max(0.0, -drag) * mixture / (mixture - liquid);
    double s = (rate + std::sqrt(rate * rate + 4 * trace)) / 4;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const double square = 4 * s * s, a = mixture * square - k11;
      const double b = liquid * (square + 2 * drag * s) - k22, c = liquid * square - k12;
      const double slope = 8 * s * mixture * b + a * liquid * (8 * s + 2 * drag) - 16 * s * liquid * c;
      const double step = (a * b - c * c) / slope;
      s -= step;
      if (!(step > 1e-6 * s)) break;  // of a limit that is safe to a fifth
    }
    return s;
  }
};

}  // namespace wetfront::mpm
