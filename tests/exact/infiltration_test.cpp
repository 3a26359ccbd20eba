#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/exact/derivative.h"
#include "tests/exact/printed.h"
#include "verification/exact/broadbridge_white.h"
#include "verification/exact/green_ampt.h"
#include "verification/exact/lambert_w.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/srivastava_yeh.h"
#include "verification/exact/warrick.h"

namespace wetfront::verification::exact {
namespace {

TEST(BroadbridgeWhite, PrintedNumbers) {
  const BroadbridgeWhite s(1.5, 0.5);
  const double surface[][2] = {{.1, .2699292}, {.5, .5028028}, {1, .6186778},
                               {2, .7217676},  {4, .7913132},  {10, .8214632}};
  for (const auto& row : surface) {
    expect_printed(s.surface_saturation(row[0]), row[1], 7, "surface");
    EXPECT_NEAR(s.saturation(0, row[0]), s.surface_saturation(row[0]), 1e-12);
  }
  expect_printed(s.saturation(1, 1), .2038947, 7);
  expect_printed(s.saturation(2, 4), .5631966, 7);
  expect_printed(BroadbridgeWhite(1.5, 2).time_to_ponding(), .3259772425, 10);
  expect_printed(s.head_of(.01), -102.798062, 6);
  expect_printed(s.head_of(.1), -11.22147, 5);
  expect_printed(s.head_of(.5), -1.924196, 6);
  expect_printed(s.head_of(.9), -.302899, 6);
}

TEST(BroadbridgeWhite, SatisfiesItsEquationSurfaceFluxAndMass) {
  double worst = 0, surface = 0, mass = 0;
  for (double c : {1.02, 1.5, 5.0})
    for (double r : {0.5, 2.0}) {
      const BroadbridgeWhite s(c, r);
      for (double part : {0.3, 0.6, 0.9}) {
        const double t = r > 1 ? part * s.time_to_ponding() : 4 * part;
        const auto theta = [&](double z) { return s.saturation(z, t); };
        const auto flux = [&](double z) {
          return s.conductivity(theta(z)) - s.diffusivity(theta(z)) * derivative(theta, z, 0.1 * z);
        };
        for (double z : {0.1, 0.3, 0.6, 1.0}) {
          if (theta(z) < 1e-3) continue;
          const double rate = derivative([&](double at) { return s.saturation(z, at); }, t, 0.05 * t);
          worst = std::max(worst, relative_residual(rate, -derivative(flux, z, 0.1 * z), r));
        }
        // one-sided, z = 0: Theta(z) from 4 points of spacing e, error e^4
        const double e = 1e-3;
        const double slope =
            (-25 * theta(0) + 48 * theta(e) - 36 * theta(2 * e) + 16 * theta(3 * e) - 3 * theta(4 * e)) / (12 * e);
        surface = std::max(surface, std::abs(s.conductivity(theta(0)) - s.diffusivity(theta(0)) * slope - r) / r);
        mass = std::max(mass, std::abs(integrate(theta, 0, 30, 1e-9) / (r * t) - 1));
      }
    }
  expect_residual(worst, 1e-6, "broadbridge_white");                 // a numerical derivative of a numerical derivative
  expect_residual(surface, 1e-4, "broadbridge_white_surface_flux");  // difference over 1e-3, C = 1.02 is the steepest
  expect_residual(mass, 1e-8, "broadbridge_white_mass");
}

TEST(BroadbridgeWhite, HeadAgreesWithDiffusivityAndTendsToTheLimit) {
  const BroadbridgeWhite s(1.5, 0.5);
  for (double theta : {0.05, 0.4, 0.95})
    EXPECT_NEAR(s.conductivity(theta) * derivative([&](double x) { return s.head_of(x); }, theta, 0.02),
                s.diffusivity(theta), 1e-9 * s.diffusivity(theta));
  EXPECT_NEAR(s.head(1, 1), s.head_of(s.saturation(1, 1)), 1e-12);
  EXPECT_NEAR(s.conductivity(s.surface_saturation(300)), 0.5, 1e-6);
  const BroadbridgeWhite pond(1.5, 2);
  EXPECT_NEAR(pond.surface_saturation(pond.time_to_ponding()), 1, 1e-12);
}

TEST(BroadbridgeWhite, RefusesWhatItCannotGive) {
  const BroadbridgeWhite pond(1.5, 2), mild(1.5, 0.5);
  EXPECT_THROW(pond.saturation(1, 0.4), std::domain_error);
  EXPECT_THROW(mild.saturation(-1, 1), std::domain_error);
  EXPECT_THROW(mild.head(50, 1), std::domain_error);
  EXPECT_THROW(mild.surface_saturation(2000), std::domain_error);
  EXPECT_TRUE(std::isinf(mild.time_to_ponding()));
  EXPECT_THROW(BroadbridgeWhite(1, 0.5), std::invalid_argument);
}

TEST(GreenAmpt, PrintedNumbers) {
  const GreenAmptSolution s({1, 1, 1});
  const double rows[][2] = {{.01, .1481651224}, {.1, .5162211614}, {.5, 1.3576766739},
                            {1, 2.1461932206},  {5, 7.0907174052}, {10, 12.6108686381}};
  for (const auto& row : rows) expect_printed(s.ponded_infiltration(row[0]), row[1], 10);
  EXPECT_NEAR(s.time_to_ponding(2), .5, 1e-15);
  expect_printed(s.rain_infiltration(2, 1.5), 2.58307388, 8);
}

TEST(GreenAmpt, SatisfiesItsRateAndJoinsAtPonding) {
  const GreenAmptSolution s({2e-6, 0.2, 0.3, 0.5});
  const double rain = 5e-6, ponding = s.time_to_ponding(rain), c = std::cos(0.5);
  double worst = 0;
  for (double t : {1e-3, 1.0, 1e3, 1e5}) {
    const double rate = derivative([&](double at) { return s.ponded_infiltration(at); }, t, 0.2 * t);
    worst = std::max(worst, std::abs(rate / s.capacity(s.ponded_infiltration(t)) - 1));
    const double later = derivative([&](double at) { return s.rain_infiltration(rain, at); }, ponding + t, 0.2 * t);
    worst = std::max(worst, t < 1 ? 0 : std::abs(later / s.capacity(s.rain_infiltration(rain, ponding + t)) - 1));
  }
  expect_residual(worst, 1e-7, "green_ampt");  // 1 s after ponding F has changed by 1e-5: 5 digits of 15 are gone
  EXPECT_NEAR(s.capacity(s.rain_infiltration(rain, ponding)), rain * c, 1e-14 * rain);  // all rain enters until then
  EXPECT_NEAR(s.rain_infiltration(rain, ponding * (1 + 1e-9)), rain * c * ponding, 1e-8 * rain * ponding);
  EXPECT_TRUE(std::isinf(s.time_to_ponding(2e-6)));
  // the slope: K cos beta and S/cos beta of the level soil
  const GreenAmptSolution level({2e-6 * c, 0.2 / c, 0.3});
  EXPECT_NEAR(s.ponded_infiltration(1e4), level.ponded_infiltration(1e4), 1e-15);
  EXPECT_THROW(s.ponded_infiltration(-1), std::domain_error);
  EXPECT_THROW(GreenAmptSolution({1, 1, 1.1}), std::invalid_argument);
}

TEST(LambertW, InvertsFromTheBranchPointToUnderflow) {
  for (double tau : {1e-12, 1e-6, 1e-3, 0.04, 0.06, 1.0, 10.0, 1e3, 1e6}) {
    const long double y = lower_branch(tau);
    EXPECT_NEAR(static_cast<double>((y - std::log1p(y)) / tau), 1, tau < 1e-5 ? 1e-6 : 1e-13) << tau;
  }
  EXPECT_NEAR(lower_branch(1e-12) / (std::sqrt(2e-12) + 2e-12 / 3), 1, 1e-12);
  EXPECT_NEAR(lambert_w_lower(-0.1), -3.577152063957297, 1e-14);  // -0.1 = w e^w, Corless et al. 1996
  for (double x : {-0.36, -0.2, -1e-3, -1e-200}) {
    const double w = lambert_w_lower(x);
    EXPECT_NEAR(w * std::exp(w) / x, 1, 1e-12);
  }
  EXPECT_THROW(lambert_w_lower(-0.4), std::domain_error);
  EXPECT_THROW(lambert_w_lower(0), std::domain_error);
}

Warrick pulse() {
  return {0.1, 1, 0.06, 0.40, 0.1, {{0, 0.9}, {10, 0.2}, {30, 0.5}}};
}

TEST(Warrick, SatisfiesRichardsSurfaceFluxAndMass) {
  const WarrickSolution s(pulse());
  double worst = 0;
  for (double t : {5.0, 20.0, 45.0}) {
    const auto head = [&](double z) { return s.head(z, t); };
    for (double z : {5.0, 20.0, 40.0}) {
      const double slope = derivative(head, z, 4), k = std::exp(0.1 * head(z));
      const double advective = 0.1 * k * slope * (slope - 1), diffusive = k * derivative(head, z, 4, 2);  // z down
      const double rate = derivative([&](double at) { return s.content(z, at); }, t, 0.8);
      worst = std::max(
          worst, relative_residual(rate, advective + diffusive, std::max(std::abs(advective), std::abs(diffusive))));
    }
    const double flux = t < 10 ? 0.9 : t < 30 ? 0.2 : 0.5, e = 0.01;
    const double slope =
        (-25 * head(0) + 48 * head(e) - 36 * head(2 * e) + 16 * head(3 * e) - 3 * head(4 * e)) / (12 * e);
    EXPECT_NEAR(std::exp(0.1 * head(0)) * (1 - slope), flux, 1e-9) << t;
    // gain over the background, which passes 0.1 down all along
    const double entered = 0.8 * std::min(t, 10.0) + 0.1 * std::clamp(t - 10, 0.0, 20.0) + 0.4 * std::max(t - 30, 0.0);
    const auto gain = [&](double z) { return s.content(z, t) - s.content(1e4, t); };
    EXPECT_NEAR(integrate(gain, 0, 1000, 1e-11), entered, 1e-9) << t;
  }
  expect_residual(worst, 1e-6, "warrick");  // second differences
}

TEST(Warrick, IsTheDeepLimitOfOneLayer) {
  const WarrickSolution s({0.1, 1, 0.06, 0.40, 0.1, {{0, 0.9}}});
  // 260 cm above the water table K differs by e^{-26} = 5e-12 from the uniform column's
  const SrivastavaYehSolution layer({0.1, 1, 0.06, 0.40, 300, 0.1, 0.9});
  for (double t : {5.0, 20.0})
    for (double depth : {0.0, 10.0, 40.0}) EXPECT_NEAR(s.head(depth, t), layer.head(300 - depth, t), 1e-8);
  EXPECT_NEAR(s.head(50, 1e5), std::log(0.9) / 0.1, 1e-9);
}

TEST(Warrick, RefusesWhatItCannotGive) {
  Warrick p = pulse();
  p.steps = {{0, -1}};
  EXPECT_THROW(WarrickSolution(p).head(0, 20), std::domain_error);
  p.steps = {{10, 0.2}, {5, 0.3}};
  EXPECT_THROW(WarrickSolution{p}, std::invalid_argument);
  p.steps = {{0, 1.2}};
  EXPECT_THROW(WarrickSolution{p}, std::invalid_argument);
  EXPECT_THROW(WarrickSolution(pulse()).head(-1, 1), std::domain_error);
}

}  // namespace
}  // namespace wetfront::verification::exact
