#pragma once

namespace wetfront::verification::exact {

/// Scaled complementary error function exp(x^2) erfc(x), to about 1e-15 relative for x >= 0 (1e-14 below: exp(x^2)
/// multiplies the rounding of x^2). Throws std::domain_error below -26, where exp(x^2) overflows.
/// erfc itself underflows at x = 27, and exp(x^2) erfc(x) is 0 times infinity beyond.
double erfcx(double x);

/// First repeated integral of erfc: ierfc(x) = exp(-x^2)/sqrt(pi) - x erfc(x), x >= 0, without the cancellation the
/// difference suffers at large x.
double ierfc(double x);

}  // namespace wetfront::verification::exact
