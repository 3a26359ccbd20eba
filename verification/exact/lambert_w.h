#pragma once

namespace wetfront::verification::exact {

/// y(tau) >= 0 with y - ln(1 + y) = tau, tau >= 0: the lower branch of Lambert's W by y = -1 - W_-1(-exp(-1 - tau)).
/// Asked this way it keeps full accuracy next to the branch point, where -exp(-1 - tau) rounds to -1/e, and at large
/// tau, where it underflows. Relative error about 1e-15. std::domain_error for tau < 0.
double lower_branch(double tau);

/// W_-1(x), -1/e <= x < 0 (Corless et al. 1996): w e^w = x with w <= -1. std::domain_error outside. Near -1/e the
/// argument itself carries half the digits: there w is good to sqrt(epsilon).
double lambert_w_lower(double x);

}  // namespace wetfront::verification::exact
