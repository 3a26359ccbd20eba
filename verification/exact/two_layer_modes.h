#pragma once

#include <vector>

namespace wetfront::verification::exact {

/// The eigenvalue problem behind Srivastava & Yeh's two layers, in self-adjoint form. With k = exp(-z/2) w, lengths in
/// 1/alpha, s_1 = 1 in the lower layer (-L1 < z < 0) and s_2 = beta in the upper one (0 < z < L2):
///   u'' + (s_i Lambda - 1/4) u = 0;  u(-L1) = 0;  u and Ks_i (u' + u/2) continuous at 0;  u' + u/2 = 0 at L2.
/// The form integral of Ks (u' + u/2)^2 shows every Lambda > 0; lambda^2 = Lambda - 1/4 and mu^2 = beta Lambda - 1/4
/// may still be negative (then sin, cos become sinh, cosh).
struct TwoLayerMedium {
  double length1, length2;  ///< alpha L1, alpha L2
  double beta;              ///< Ks1 dtheta2/(Ks2 dtheta1)
  double ratio;             ///< Ks1/Ks2
};

/// One eigenfunction: u = S(z + L1) below, u = A [S(L2 - z) + 2 C(L2 - z)] above, where S(x) = sin(m x)/m,
/// C(x) = cos(m x) with m^2 = lambda^2 or mu^2. norm = integral of (Ks/Ks2) s_i u^2 over both layers.
struct TwoLayerMode {
  double eigenvalue;  ///< Lambda
  double lambda_squared, mu_squared;
  double amplitude;  ///< A
  double norm;
};

/// S and C above for any sign of m^2 (S -> x, C -> 1 as m -> 0).
double sine_over(double m_squared, double x);
double cosine(double m_squared, double x);
/// Integral of S^2 from 0 to x.
double integral_of_sine_squared(double m_squared, double x);

/// Pruefer angle of the solution that starts with u = 0 at -L1: tan(angle) = u/u' at L2, counted continuously. It rises
/// strictly with Lambda, so the n-th eigenvalue (n = 0, 1, ...) is where it passes pi - atan(2) + n pi: none is missed
/// however close two of them lie, which scanning F(Lambda) for sign changes cannot promise.
double pruefer_angle(const TwoLayerMedium& medium, double eigenvalue);

/// F(Lambda) = (S1 + 2 C1)(S2 + 2 C2) - (Ks2/Ks1)(1 + 4 mu^2) S1 S2: zero at every eigenvalue (check, not search).
double characteristic(const TwoLayerMedium& medium, double eigenvalue);

/// The first `count` modes in ascending order.
std::vector<TwoLayerMode> two_layer_modes(const TwoLayerMedium& medium, int count);

}  // namespace wetfront::verification::exact
