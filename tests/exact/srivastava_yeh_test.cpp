#include "verification/exact/srivastava_yeh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/exact/derivative.h"
#include "tests/exact/printed.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/srivastava_yeh_slope.h"

namespace wetfront::verification::exact {
namespace {

// Everything in cm and h: the solution is free of units, and so are the printed numbers.
SrivastavaYeh wetting(double alpha) {
  return {alpha, 1, 0.06, 0.40, 100, 0.1, 0.9};
}
SrivastavaYeh drainage(double alpha) {
  return {alpha, 1, 0.06, 0.40, 100, 0.9, 0.1};
}
const double times[] = {1, 5, 10, 20, 50, 100};

/// theta_t = d/dz [K (psi_z + slope)] at z, t; relative to the largest term.
template <class Solution>
double richards_residual(const Solution& s, double alpha, double ks, double gravity, double z, double t) {
  const auto head = [&](double at) { return s.head(at, t); };
  const auto conductivity = [&](double at) { return ks * std::exp(alpha * s.head(at, t)); };
  const double slope = derivative(head, z, 4), curvature = derivative(head, z, 4, 2);
  const double k = conductivity(z), rate = derivative([&](double at) { return s.content(z, at); }, t, 0.2 * t);
  const double advective = derivative(conductivity, z, 4) * (slope + gravity), diffusive = k * curvature;
  return relative_residual(rate, advective + diffusive, std::max(std::abs(advective), std::abs(diffusive)));
}

TEST(SrivastavaYehOneLayer, PrintedNumbers) {
  const SrivastavaYehSolution wet(wetting(0.1)), dry(drainage(0.1)), mild(wetting(0.01));
  const double rows[][7] = {{50, -22.437112, -21.523437, -14.190128, -5.429244, -1.284340, -1.048267},
                            {70, -22.939159, -15.330834, -7.563291, -2.920552, -1.141852, -1.053374},
                            {90, -17.430388, -6.000090, -3.106182, -1.604179, -1.077431, -1.053673},
                            {100, -7.259491, -3.065775, -1.912903, -1.285836, -1.063554, -1.053640}};
  for (const auto& row : rows)
    for (int i = 0; i < 6; ++i) expect_printed(wet.head(row[0], times[i]), row[i + 1], 6, "wetting");
  const double table[] = {.100000, .100001, .103600, .266434, .833411, .899358};
  const double drained[] = {-6.612992, -13.314883, -17.478233, -21.144028, -22.932252, -23.020998};
  const double gentle[] = {-55.422333, -32.486470, -20.794269, -11.215369, -6.717186, -6.530742};
  for (int i = 0; i < 6; ++i) {
    expect_printed(wet.water_table_flux(times[i]), table[i], 6, "water table");
    expect_printed(dry.head(100, times[i]), drained[i], 6, "drainage");
    expect_printed(mild.head(100, times[i]), gentle[i], 6, "alpha 0.01");
  }
  const double steep_roots[] = {.26536624, .54543538, .83913455, 1.14086265},
               mild_roots[] = {1.8365972, 4.81584232, 7.91705268};
  for (int i = 0; i < 4; ++i) expect_printed(wet.roots()[i], steep_roots[i], 8);
  expect_printed(mild.roots()[0], mild_roots[0], 7);
  for (int i = 1; i < 3; ++i) expect_printed(mild.roots()[i], mild_roots[i], 8);
}

TEST(SrivastavaYehOneLayer, SatisfiesRichards) {
  double worst = 0;
  for (double alpha : {0.1, 0.01})
    for (const SrivastavaYeh& p : {wetting(alpha), drainage(alpha)}) {
      const SrivastavaYehSolution s(p);
      for (double t : times)
        for (double z : {20.0, 50.0, 70.0, 90.0}) {
          // ahead of the front both sides are differences of nothing: there the initial state is the test
          if (std::abs(s.content(z, t) - s.content(z, 0)) < 1e-4) continue;
          worst = std::max(worst, richards_residual(s, alpha, 1, 1, z, t));
        }
    }
  expect_residual(worst, 1e-6, "srivastava_yeh");  // second differences of a head with 12 digits
}

TEST(SrivastavaYehOneLayer, SurfaceFluxAndMassClose) {
  const SrivastavaYehSolution s(wetting(0.1));
  for (double t : times) {
    const double stored = integrate([&](double z) { return s.content(z, t) - s.content(z, 0); }, 0, 100, 1e-11);
    // A first sliver too early for the series passes the initial flux to 1e-20 (alpha L = 10).
    const double drained = 0.1 * 0.01 + integrate([&](double at) { return s.water_table_flux(at); }, 0.01, t, 1e-11);
    EXPECT_NEAR(stored, 0.9 * t - drained, 1e-9 * t) << t;
  }
}

TEST(SrivastavaYehOneLayer, TendsToTheSteadyState) {
  const SrivastavaYehSolution s(wetting(0.1));
  for (double z : {0.0, 30.0, 100.0})
    EXPECT_NEAR(s.head(z, 2000), std::log(0.9 - (0.9 - 1) * std::exp(-0.1 * z)) / 0.1, 1e-11);
  EXPECT_NEAR(s.water_table_flux(2000), 0.9, 1e-12);
}

TEST(SrivastavaYehOneLayer, RefusesWhatItCannotGive) {
  const SrivastavaYehSolution few(wetting(0.1), 5), s(wetting(0.1));
  EXPECT_THROW(few.head(50, 1), std::domain_error);   // 5 terms do not reach 1e-20 at t = 1 h
  EXPECT_THROW(s.head(50, 1e-6), std::domain_error);  // nor do 2000 at 1e-6 h
  EXPECT_THROW(s.head(50, -1), std::domain_error);
  EXPECT_THROW(s.head(101, 1), std::domain_error);
  SrivastavaYeh thick = wetting(0.1);
  thick.thickness = 1000;  // exp((L - z)/2) = e^50 multiplies a sum that must cancel it
  EXPECT_THROW(SrivastavaYehSolution(thick).head(10, 1), std::domain_error);
  SrivastavaYeh p = wetting(0.1);
  p.flux_after = 1.1;
  EXPECT_THROW(SrivastavaYehSolution{p}, std::invalid_argument);
  p = wetting(0.1), p.flux_after = -1;  // e^{-10} is all the water table can send up
  EXPECT_THROW(SrivastavaYehSolution{p}, std::invalid_argument);
}

TEST(SrivastavaYehSlope, SatisfiesRichardsAlongTheNormal) {
  for (double degrees : {0.0, 30.0, 60.0}) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle);
    const SrivastavaYehSlopeSolution s({0.1, 1, 0.06, 0.40, 100, angle, 0.1, 0.9});
    double worst = 0, surface = 0;
    for (double t : {5.0, 10.0, 20.0, 50.0}) {
      for (double n : {50.0, 70.0, 90.0}) {
        if (std::abs(s.content(n, t) - s.content(n, 0)) < 1e-4) continue;
        worst = std::max(worst, richards_residual(s, 0.1, 1, c, n, t));
      }
      // rain per horizontal area: I cos beta per area of slope enters the sliver below the surface
      const double n = 99.999, k = std::exp(0.1 * s.head(n, t));
      const double flux = k * (derivative([&](double at) { return s.head(at, t); }, n, 0.001) + c);
      surface = std::max(surface, std::abs(flux - 0.9 * c));
    }
    expect_residual(worst, 1e-6, "srivastava_yeh_slope");
    EXPECT_LT(surface, 1e-3) << degrees;  // flux 0.001 cm below the surface: the front takes up theta_t * 0.001
  }
}

TEST(SrivastavaYehSlope, IsTheLevelLayerAtNoAngleAndSteadyAtTheEnd) {
  const SrivastavaYehSlopeSolution flat({0.1, 1, 0.06, 0.40, 100, 0, 0.1, 0.9, -5});
  SrivastavaYeh p = wetting(0.1);
  p.base_head = -5;
  const SrivastavaYehSolution level(p);
  EXPECT_DOUBLE_EQ(flat.head(70, 10), level.head(70, 10));
  const double angle = 0.6, c = std::cos(angle);
  const SrivastavaYehSlopeSolution s({0.1, 1, 0.06, 0.40, 100, angle, 0.1, 0.9, -5});
  EXPECT_NEAR(s.head(0, 10), -5, 1e-12);
  // K (psi_n + cos beta) = I cos beta: K/Ks = q - (q - e^{alpha psi0}) e^{-alpha n cos beta}
  EXPECT_NEAR(s.head(40, 5000), std::log(0.9 - (0.9 - std::exp(-0.5)) * std::exp(-4 * c)) / 0.1, 1e-10);
  EXPECT_NEAR(s.head(40, 0), std::log(0.1 - (0.1 - std::exp(-0.5)) * std::exp(-4 * c)) / 0.1, 1e-10);
  EXPECT_NEAR(s.water_table_flux(5000), 0.9 * c, 1e-12);
  EXPECT_THROW(SrivastavaYehSlopeSolution({0.1, 1, 0.06, 0.40, 100, 1.6, 0.1, 0.9}), std::invalid_argument);
}

}  // namespace
}  // namespace wetfront::verification::exact
