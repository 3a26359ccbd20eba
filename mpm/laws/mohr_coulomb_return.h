#pragma once

#include "mpm/lanes.h"

#include <array>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

/// Strength in the form in which the yield condition uses it. S is `double` where all points share it, else T.
template <class S>
struct MohrCoulombStrength {
  S sin_friction;   ///< sin phi
  S cohesive;       ///< 2 c cos phi [Pa]
  S sin_dilatancy;  ///< sin psi
  S cut_off;        ///< largest tensile principal stress [Pa]; read only where the law has a cut-off
};

/// Return to the Mohr-Coulomb pyramid in principal stresses s1 >= s2 >= s3 (tension-positive),
///
///     f = s1 (1 + sin phi) - s3 (1 - sin phi) - 2 c cos phi <= 0,   flow along df/dsigma with psi in place of phi,
///
/// for isotropic linear elasticity. All surfaces are planes, so every return is closed: to the face, to an edge (two
/// faces), to the apex (de Souza Neto, Peric & Owen 2008, section 8.2; Clausen, Damkilde & Andersen 2007), and with a
/// cut-off to s_i <= T (associated) and to where both meet. All are computed and one is selected, so lanes do not part.
template <class S>
class MohrCoulombReturn {
 public:
  MohrCoulombReturn(const MohrCoulombStrength<S>& strength, double lambda, double shear)
      : sf_(strength.sin_friction),
        cohesive_(strength.cohesive),
        lambda_(lambda),
        shear_(shear),
        cut_off_(strength.cut_off) {
    const S sd = strength.sin_dilatancy, volumetric = sd * (2 * lambda);
    towards_first_ = (sd + 1.0) * (2 * shear) + volumetric;     // -d s1 per unit of flow on the face
    towards_third_ = (S(1.0) - sd) * (2 * shear) - volumetric;  // +d s3
    towards_second_ = volumetric;                               // -d s2
    first_pair_ = (sd + 1.0) * shear + volumetric;              // -d of the mean of s1, s2 on their edge
    third_pair_ = (S(1.0) - sd) * shear - volumetric;           // +d of the mean of s2, s3 on theirs
    const S both = sf_ * sd * (4 * lambda);
    const S face = (sf_ * sd + 1.0) * (4 * shear) + both;
    per_face_ = S(1.0) / face;
    per_first_edge_ = S(2.0) / (face + (S(1.0) - sf_) * (S(1.0) - sd) * (2 * shear) + both);
    per_third_edge_ = S(2.0) / (face + (sf_ + 1.0) * (sd + 1.0) * (2 * shear) + both);
    side_[0] = S(1.0) - sd;
    side_[1] = S(1.0) + sd;
    per_third_ = S(1.0) / (S(1.0) - sf_);
    // Without friction there is no apex.
    apex_ = select(sf_ > 0.0, cohesive_ / (max(sf_, S(1e-300)) * 2.0), S(std::numeric_limits<double>::max()));
  }

  /// f [Pa]: positive outside. Twice the distance of Mohr's circle from the line, over cos phi.
  template <class T>
  T yield(const T& first, const T& third) const {
    return first * (sf_ + 1.0) - third * (S(1.0) - sf_) - cohesive_;
  }
  /// s3 on the surface at a given s1.
  template <class T>
  T third_on_surface(const T& first) const {
    return (first * (sf_ + 1.0) - cohesive_) * per_third_;
  }
  const S& apex() const { return apex_; }

  /// For trial values with f > 0.
  template <class T>
  [[gnu::always_inline]] std::array<T, 3> without_cut_off(const std::array<T, 3>& trial) const {
    const T flow = yield(trial[0], trial[2]) * per_face_;
    std::array<T, 3> out{trial[0] - flow * towards_first_, trial[1] - flow * towards_second_, T(0.0)};
    out[2] = third_on_surface(out[0]);
    const auto off_face = out[1] > out[0] || out[1] < trial[2] + flow * towards_third_;
    if (any(off_face)) to_edge_or_apex(trial, off_face, out);
    return out;
  }
  /// For trial values with f > 0 or s1 > cut-off.
  template <class T>
  std::array<T, 3> with_cut_off(const std::array<T, 3>& trial) const {
    const T top(cut_off_);
    const std::array<T, 3> cut = tension_only(trial, top);
    const auto cut_holds = !(yield(cut[0], cut[2]) > 0.0);
    std::array<T, 3> sheared = without_cut_off(trial);
    const auto inside = !(yield(trial[0], trial[2]) > 0.0);
    const auto shear_holds = !inside && !(sheared[0] > top);
    const std::array<T, 3> corner = tension_and_shear(trial, top);
    std::array<T, 3> out;
    for (int k = 0; k < 3; ++k) out[k] = select(cut_holds, cut[k], select(shear_holds, sheared[k], corner[k]));
    return out;
  }

 private:
  template <class T, class Mask>
  [[gnu::always_inline]] void to_edge_or_apex(const std::array<T, 3>& trial, const Mask& off_face,
                                              std::array<T, 3>& out) const {
    // On which side of the plane through the apex along the face's flow the trial lies.
    const auto third_edge = trial[0] * side_[0] - trial[1] * 2.0 + trial[2] * side_[1] > 0.0;
    const T first_pair = (trial[0] + trial[1]) * 0.5, third_pair = (trial[1] + trial[2]) * 0.5;
    const T flow = select(third_edge, yield(trial[0], third_pair) * per_third_edge_,
                          yield(first_pair, trial[2]) * per_first_edge_);
    const T first = select(third_edge, trial[0] - flow * towards_first_, first_pair - flow * first_pair_);
    const T third = select(third_edge, third_pair + flow * third_pair_, trial[2] + flow * towards_third_);
    const auto beyond_apex = third > first;
    const T low = third_on_surface(first), apex(apex_);
    const T top = select(beyond_apex, apex, first), bottom = select(beyond_apex, apex, low);
    out[0] = select(off_face, top, out[0]);
    out[1] = select(off_face, select(third_edge, bottom, top), out[1]);
    out[2] = select(off_face, bottom, out[2]);
  }
  /// Rankine's return to s_i <= top: face, edge, apex.
  template <class T>
  std::array<T, 3> tension_only(const std::array<T, 3>& trial, const T& top) const {
    const double modulus = lambda_ + 2 * shear_;
    const T face = max(trial[0] - top, T(0.0)) * (lambda_ / modulus);
    const T edge = (trial[0] + trial[1] - top * 2.0) * (lambda_ / (2 * lambda_ + 2 * shear_));
    const auto on_edge = trial[1] - face > top;
    return {min(trial[0], top), min(trial[1] - face, top), min(trial[2] - select(on_edge, edge, face), top)};
  }
  /// s1 = top and f = 0; s2 by the flow of both, or on one more plane.
  template <class T>
  std::array<T, 3> tension_and_shear(const std::array<T, 3>& trial, const T& top) const {
    const double modulus = lambda_ + 2 * shear_;
    const T low = third_on_surface(top);
    const T drop = trial[0] - top, rise = low - trial[2];
    // modulus d_t + towards_first d_f = drop,  -lambda d_t + towards_third d_f = rise
    const auto determinant = towards_third_ * modulus + towards_first_ * lambda_;
    const T by_tension = (drop * towards_third_ - rise * towards_first_) / determinant;
    const T by_shear = (rise * modulus + drop * lambda_) / determinant;
    const T second = trial[1] - by_tension * lambda_ - by_shear * towards_second_;
    return {top, min(max(second, low), top), low};
  }

  S sf_, cohesive_;
  double lambda_, shear_;
  S cut_off_;
  S towards_first_{}, towards_third_{}, towards_second_{}, first_pair_{}, third_pair_{};
  S per_face_{}, per_first_edge_{}, per_third_edge_{}, per_third_{}, apex_{};
  std::array<S, 2> side_{};
};

}  // namespace wetfront::mpm
