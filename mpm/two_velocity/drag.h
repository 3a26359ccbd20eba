#pragma once

#include <cmath>

/// The drag between the phases in the nodal solve, as a strategy: what distinguishes `implicit-drag` from `explicit`.
/// A skeleton is compiled for one of them (skeleton.h), so that no node asks which it is.
namespace wetfront::mpm {

/// One axis of one node (or of four: Lanes) before the solve.
template <class Number = double>
struct NodalDrag {
  Number before{};        ///< v_l at the start of the step [m/s]
  Number solid_before{};  ///< v_s at the start of the step [m/s]
  Number pushed{};        ///< v_l + dt F_l/(rho_l V), all forces but drag [m/s]
  Number both{};          ///< v_s + m v_l + dt F/m_s, momentum of both phases over m_s [m/s]; 0: skeleton held
  Number ratio{};         ///< m = m_l/m_s [-]; 0: skeleton held
  Number drag{};          ///< dt r, r = nS mu/(k k_rel rho_l) [-]
};

/// Drag at the end of the step: (1 + d) v_l' - d v_s' = pushed, v_s' + m v_l' = both. Exact for any dt.
struct ImplicitDrag {
  static constexpr const char* name = "implicit drag";
  static constexpr const char* limit = "(b r + sqrt(b^2 r^2 + 4 w^2))/w^2";
  template <class Number>
  static Number liquid(const NodalDrag<Number>& n) {
    return (n.pushed + n.drag * n.both) / (1.0 + n.drag + n.drag * n.ratio);
  }
  /// Largest stable step: w^2 dt^2 <= 4 + 2 b r dt (README.md section 6). The least drag of a cell decides.
  static double stable_step(double least_drag, double, double mapping, double omega_squared) {
    const double r = mapping * least_drag;
    return (r + std::sqrt(r * r + 4 * omega_squared)) / omega_squared;
  }
};

/// Drag at the start of the step, as in Lee et al. 2021: v_l' = pushed - d (v_l - v_s).
struct ExplicitDrag {
  static constexpr const char* name = "explicit drag";
  static constexpr const char* limit = "(-r + sqrt(r^2 + 4 w^2))/w^2";
  template <class Number>
  static Number liquid(const NodalDrag<Number>& n) {
    return n.pushed - n.drag * (n.before - n.solid_before);
  }
  /// w^2 dt^2 + 2 r dt <= 4. The largest drag of a cell decides; written without the cancellation of the formula's
  /// two terms at large r.
  static double stable_step(double, double most_drag, double, double omega_squared) {
    return 4 / (most_drag + std::sqrt(most_drag * most_drag + 4 * omega_squared));
  }
};

}  // namespace wetfront::mpm
