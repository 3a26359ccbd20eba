#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/exact/derivative.h"
#include "tests/exact/printed.h"
#include "verification/exact/erfcx.h"
#include "verification/exact/iverson.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/terzaghi.h"

namespace wetfront::verification::exact {
namespace {

constexpr double degree = std::numbers::pi / 180, day = 86400;

Iverson minor_creek() {
  return {15 * degree, 1e-6, 1, 10 * day, 2};
}

TEST(Iverson, PrintedNumbers) {
  const double response[][3] = {{.5, .0084907026, 10}, {1, .0502545417, 10},  {2, .1666309412, 10},
                                {5, .5057938381, 10},  {10, .9596214127, 10}, {100, 4.69822095, 8}};
  for (const auto& row : response) expect_printed(iverson_response(row[0]), row[1], static_cast<int>(row[2]));
  const IversonSolution s(minor_creek());
  const SlopeStrength strength{18 * degree, 4e3, 22e3, 9.81e3};
  const double rows[][3] = {{5, .008111, 1.57390},
                            {10, .062573, 1.55812},
                            {20, .177225, 1.52490},
                            {30, .194393, 1.51992},
                            {60, .172411, 1.52629}};
  for (const auto& row : rows) {
    const double head = s.head(2, row[0] * day);
    expect_printed(head, row[1], 6, "psi");
    expect_printed(infinite_slope_safety(strength, 15 * degree, 2, head), row[2], 5, "FS");
  }
}

TEST(Iverson, SatisfiesDiffusionAndTheRainAtTheSurface) {
  const Iverson p = minor_creek();
  const IversonSolution s(p);
  const double diffusion = p.diffusivity * std::pow(std::cos(p.slope_angle), 2),
               beta = std::pow(std::cos(p.slope_angle), 2);
  double worst = 0;
  for (double days : {3.0, 8.0, 15.0, 40.0})
    for (double depth : {0.5, 1.0, 2.0}) {
      const double rate = derivative([&](double t) { return s.head(depth, t); }, days * day, 0.1 * days * day);
      const double spread = diffusion * derivative([&](double z) { return s.head(z, days * day); }, depth, 0.2, 2);
      worst = std::max(worst, relative_residual(rate, spread));
    }
  expect_residual(worst, 1e-6, "iverson");  // second differences
  const double e = 1e-3;
  const auto slope = [&](double days) {
    const auto h = [&](int i) { return s.head(i * e, days * day); };
    return (-25 * h(0) + 48 * h(1) - 36 * h(2) + 16 * h(3) - 3 * h(4)) / (12 * e);
  };
  EXPECT_NEAR(slope(5), beta - 1, 1e-9);  // raining: beta - I/Kz
  EXPECT_NEAR(slope(30), beta, 1e-9);     // after
}

TEST(Iverson, LongRainLeavesThePhysicalRangeAndSaysSo) {
  Iverson p = minor_creek();
  p.duration = 1000 * day;
  const IversonSolution s(p);
  EXPECT_FALSE(s.exceeds_beta_line(2, 5 * day));
  EXPECT_TRUE(s.exceeds_beta_line(2, 900 * day));
  EXPECT_NEAR(IversonSolution(minor_creek()).head(2, 1e6 * day), 0, 1e-2);  // back to the water table
  EXPECT_THROW(s.head(-1, 1), std::domain_error);
  p.slope_angle = 0;
  EXPECT_THROW(IversonSolution{p}, std::invalid_argument);
  EXPECT_THROW(infinite_slope_safety({0.3, 0, 2e4, 1e4}, 0.2, 0, 0), std::domain_error);
}

TEST(ErrorFunctions, ScaledAndIntegrated) {
  for (double x : {-3.0, 0.0, 0.5, 2.0, 2.999, 3.0, 5.0, 20.0}) {
    const long double lx = x, scaled = std::exp(lx * lx) * std::erfc(lx);
    EXPECT_NEAR(erfcx(x) / static_cast<double>(scaled), 1, 1e-14) << x;
  }
  EXPECT_NEAR(erfcx(1e8) * 1e8 / std::numbers::inv_sqrtpi, 1, 1e-15);
  for (double x : {0.1, 1.0, 2.9, 3.1, 6.0})
    EXPECT_NEAR(integrate([](double y) { return std::erfc(y); }, x, x + 12, 1e-13) / ierfc(x), 1, 1e-11) << x;
  EXPECT_THROW(erfcx(-27), std::domain_error);
}

TEST(Terzaghi, PrintedNumbers) {
  const double settled[][2] = {{.05, .2523132522}, {.1, .3568234005}, {.2, .5040878202},
                               {.5, .7639503307},  {1, .9312596785},  {2, .9941704789}};
  for (const auto& row : settled) expect_printed(terzaghi_degree(row[0]), row[1], 10);
  expect_printed(terzaghi_time_factor(.5), .196730740, 9);
  expect_printed(terzaghi_time_factor(.9), .848085408, 9);
  const double base[][2] = {
      {.05, .9968691955}, {.1, .9493053627}, {.2, .7723116069}, {.5, .3707774298}, {1, .1079770444}};
  for (const auto& row : base) expect_printed(terzaghi_pressure(1, row[0]), row[1], 10);
  const double oedometer = 10e6 * .7 / (1.3 * .4);
  const TerzaghiSolution soft({1, 1e-4, 9810, oedometer, 1e4, .4, .2e9});
  expect_printed(soft.initial_pressure() / 1e4, .973783, 6);
  expect_printed(soft.consolidation_coefficient(), .133625, 6);
}

TEST(Terzaghi, SatisfiesDiffusionAndMass) {
  double worst = 0;
  for (double t : {.01, .05, .15, .199, .201, .5, 1.5})
    for (double z : {.1, .5, .9}) {
      const auto at_time = [&](double x) { return terzaghi_pressure(z, x); };
      const auto at_depth = [&](double x) { return terzaghi_pressure(x, t); };
      worst = std::max(worst, relative_residual(derivative(at_time, t, 0.1 * t), derivative(at_depth, z, 0.08, 2), 1));
      EXPECT_NEAR(integrate([&](double x) { return terzaghi_pressure(x, t); }, 0, 1), 1 - terzaghi_degree(t), 1e-12);
    }
  expect_residual(worst, 1e-6, "terzaghi");                                    // second differences
  EXPECT_NEAR(terzaghi_degree(1e-8), 2e-4 * std::numbers::inv_sqrtpi, 1e-16);  // 2 sqrt(T/pi)
  // early, the base is not felt: the half-space's answer, which the modes (every partial sum solves the equation) miss
  for (double t : {.002, .01}) {
    EXPECT_NEAR(terzaghi_degree(t), 2 * std::sqrt(t / std::numbers::pi), 1e-15) << t;
    EXPECT_NEAR(terzaghi_pressure(.1, t), std::erf(.05 / std::sqrt(t)), 1e-14) << t;
  }
  // the two forms meet
  EXPECT_NEAR(terzaghi_pressure(.4, std::nextafter(.2, 0)), terzaghi_pressure(.4, .2), 1e-14);
  EXPECT_NEAR(terzaghi_degree(std::nextafter(.2, 0)), terzaghi_degree(.2), 1e-14);
}

TEST(Terzaghi, SettlesByTheLoadOverTheModulusInTheEnd) {
  const TerzaghiSolution s({2, 1e-4, 9810, 1e7, 1e4, .4, .2e9});
  EXPECT_NEAR(s.settlement(0), 2 / 1e7 * (1e4 - s.initial_pressure()), 1e-18);
  EXPECT_NEAR(s.settlement(1e5), 2e-3, 1e-15);
  EXPECT_NEAR(s.pressure(1, 1e5), 0, 1e-10);
  // what leaves through the top, (k/gamma_w) p_z, is what the layer yields: skeleton by settlement, water by n/Kw
  const double t = 5, storage = .4 / .2e9;
  const double outflow = 1e-4 / 9810 * s.pressure(1e-4, t) / 1e-4;
  const auto held = [&](double at) {
    return -s.settlement(at) + storage * integrate([&](double z) { return s.pressure(z, at); }, 0, 2);
  };
  EXPECT_NEAR(-derivative(held, t, 0.5) / outflow, 1, 1e-6);
  EXPECT_THROW(TerzaghiSolution({0, 1e-4, 9810, 1e7, 1e4}), std::invalid_argument);
  EXPECT_THROW(terzaghi_pressure(1.1, 1), std::domain_error);
  EXPECT_THROW(terzaghi_time_factor(1), std::domain_error);
}

}  // namespace
}  // namespace wetfront::verification::exact
