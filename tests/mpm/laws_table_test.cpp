// Tables of all laws against the laws themselves: the bound that mpm/laws/log_table.h states, over many parameters.
#include "mpm/laws/soil_water.h"
#include "tests/mpm/strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace wetfront::mpm {
namespace {

struct Named {
  std::string name;
  Soil soil;
};

Soil soil_of(RetentionSpec retention, PermeabilitySpec permeability) {
  Soil soil = test::seed_sand(0.087);
  soil.retention = std::move(retention);
  soil.permeability = std::move(permeability);
  return soil;
}

/// Sands to clay (n = 1/(1 - lambda) from 10 to 1.1), with and without residual water and cut-off; every other law with
/// its published parameters, in pascals of water at 9.81 kN/m3.
std::vector<Named> all_laws() {
  std::vector<Named> laws;
  for (double n : {1.1, 1.2, 1.5, 2.0, 2.56, 4.0, 7.0, 10.0})
    for (double entry : {500.0, 4350.0, 50e3})
      for (double s_min : {0.0, 0.3, 0.87})
        for (double cut_off : {0.0, 200.0}) {
          const VanGenuchtenRetention curve{entry, 1 - 1 / n, s_min, 0.95, cut_off};
          const std::string name = "van Genuchten n " + std::to_string(n) + " p0 " + std::to_string(entry) + " S_min " +
                                   std::to_string(s_min) + " cut-off " + std::to_string(cut_off);
          laws.push_back({name, soil_of(curve, MualemPermeability{})});
          laws.push_back({name + " printed", soil_of(curve, PrintedMualemPermeability{})});
          laws.push_back({name + " of S", soil_of(curve, MualemOfSaturationPermeability{})});
        }
  laws.push_back({"exponential", soil_of(ExponentialRetention{981, 0.1, 1}, ExponentialPermeability{981})});
  const double cm = 98.1;
  laws.push_back({"Haverkamp sand", soil_of(HaverkampRetention{1.611e6 * std::pow(cm, 3.96), 3.96, 0.26, 1},
                                            HaverkampPermeability{1.175e6 * std::pow(cm, 4.74), 4.74})});
  laws.push_back({"Haverkamp Yolo clay", soil_of(HaverkampLogRetention{739, 4, cm, 0.25, 1},
                                                 HaverkampPermeability{124.6 * std::pow(cm, 1.77), 1.77})});
  for (double c : {1.02, 1.5, 5.0})
    laws.push_back({"Broadbridge & White c " + std::to_string(c),
                    soil_of(BroadbridgeWhiteRetention{c, 1000, 0.1, 0.9}, BroadbridgeWhitePermeability{})});
  laws.push_back({"points", soil_of(PointsRetention{{0, 500, 2e3, 5e3, 20e3, 100e3}, {1, 1, 0.9, 0.6, 0.3, 0.2}},
                                    PointsPermeability{{0, 2e3, 5e3, 20e3, 100e3}, {1, 0.5, 0.05, 1e-4, 1e-7}})});
  return laws;
}

/// Suctions from 1 mPa to 1e8 Pa that are no ends of pieces.
std::vector<double> suctions(double origin) {
  std::vector<double> out;
  for (double x = 1e-3; x < 1e8; x *= 1.0137) out.push_back(origin + x);
  return out;
}

TEST(LogTable, HoldsItsBoundForEveryRetentionCurve) {
  for (const auto& [name, soil] : all_laws()) {
    const SampledRetention law = sampled_retention(*soil.retention);
    const TabulatedCurve table(law);
    double worst = 0;
    for (double s : suctions(law.effective.origin))
      worst = std::max(worst, std::abs(table.effective(s) - law.effective.at(s).value));
    // Points have kinks of curvature, d^2 times their jump; the rest are smooth: d^4 f'''' / 384 (log_table.h).
    EXPECT_LE(worst, name == "points" ? 3e-6 : 2e-8) << name;
    EXPECT_EQ(table.saturation(law.effective.origin), law.s_max) << name;
  }
}

TEST(LogTable, HoldsItsBoundForEveryPermeability) {
  for (const auto& [name, soil] : all_laws()) {
    const SampledLaw law = sampled_permeability(soil);
    const TabulatedPermeability table(law);
    const TabulatedCurve curve(sampled_retention(*soil.retention));
    double worst = 0, relative = 0;
    // The first piece is a blend: 8 Pa where Mualem's slope is unbounded.
    const double first = law.origin + (name.find("n 1.") != std::string::npos && law.origin == 0 ? 8 : 1);
    for (double s : suctions(law.origin)) {
      const double exact = law.at(s).value, error = std::abs(table(curve, s).value - exact);
      if (s < first) {
        EXPECT_LE(error, law.top - law.at(first).value + 1e-12) << name << " s " << s;
        continue;
      }
      worst = std::max(worst, error);
      if (exact > 1e-12) relative = std::max(relative, error / exact);
    }
    EXPECT_LE(worst, name == "points" ? 1e-5 : 1e-7) << name;
    // q of log_table.h is at most 25 where k_rel > 1e-12 (n = 10: k ~ s^-25).
    EXPECT_LE(relative, name == "points" ? 1e-4 : 6e-6) << name;
  }
}

TEST(LogTable, SlopeAndIntegralBelongToTheValue) {
  for (const auto& [name, soil] : all_laws()) {
    const LogTable table(sampled_permeability(soil), 0);
    const double top = table.value(table.origin());
    for (double s : {0.3, 7.7, 130.0, 1234.0, 5e3, 33e3, 5e5}) {
      const double x = table.origin() + s, d = 1e-5 * s;
      const double rise = (table.value(x + d) - table.value(x - d)) / (2 * d);
      EXPECT_NEAR(table.at(x).slope, rise, 1e-5 * std::abs(rise) + 1e-10 * top / s) << name << " s " << s;
      // Simpson's rule, error d^5/90 f''''; what is left is cancellation.
      const double area = d / 3 * (table.value(x - d) + 4 * table.value(x) + table.value(x + d));
      EXPECT_NEAR(table.integral(x - d) - table.integral(x + d), area,
                  1e-8 * area + 1e-13 * (table.integral(x) + top * s))
          << name << " s " << s;
      // No piece rises: Newton's matrix keeps its signs.
      EXPECT_LE(table.at(x).slope, 1e-11 * top / s) << name;  // round-off over the width of a piece
    }
    EXPECT_NEAR(table.integral(-100) - table.integral(table.origin()), top * (100 + table.origin()),
                1e-12 * table.integral(-100));
  }
}

TEST(LogTable, InvertsItself) {
  for (const auto& [name, soil] : all_laws()) {
    const TabulatedCurve curve(sampled_retention(*soil.retention));
    for (double s : {1.5, 130.0, 1234.0, 5e3, 33e3}) {
      const double x = curve.saturated_until() + s;
      const ValueAndSlope se = curve.effective_at(x);
      if (!(se.slope < -1e-12) || se.value > 1 - 1e-8) continue;  // flat: any suction will do
      // The value is known to round-off, the suction to round-off over the slope.
      EXPECT_NEAR(curve.suction_at(se.value), x, 1e-14 * x - 4e-16 / se.slope) << name;
    }
    EXPECT_EQ(curve.suction_at(1.0), curve.saturated_until());
  }
}

TEST(SampledLaws, ReproducePublishedValues) {
  const double cm = 98.1;
  // Celia et al. 1990 / Haverkamp 1977 sand: theta(-61.5 cm) = 0.1 of 0.075..0.287; Se = a/(a + 61.5^3.96).
  const auto sand = sampled_retention(HaverkampRetention{1.611e6 * std::pow(cm, 3.96), 3.96, 0.075 / 0.287, 1});
  const double theta = 0.287 * (sand.s_min + (1 - sand.s_min) * sand.effective.at(61.5 * cm).value);
  EXPECT_NEAR(theta, 0.1, 2e-4);
  // Vogel, van Genuchten & Cislerova 2001: Se and k are 1 at the cut-off and the plain curve's shape beyond.
  const VanGenuchten plain({10e3, 0.1, 0, 1});
  Soil clay = soil_of(VanGenuchtenRetention{10e3, 0.1, 0, 1, 200}, MualemPermeability{});
  const auto laws = tabulated_soil_water(clay, test::seed_water());
  EXPECT_EQ(laws.curve.effective(150), 1);
  EXPECT_NEAR(laws.curve.effective(5e3), plain.effective(5e3) / plain.effective(200), 1e-9);
  EXPECT_NEAR(laws.permeability(laws.curve, 5e3).value, Mualem{}(plain, 5e3).value / Mualem{}(plain, 200).value, 1e-9);
  // Broadbridge & White: their curve at Se = 1/2, c = 1.02.
  const auto bw = sampled_retention(BroadbridgeWhiteRetention{1.02, 1000, 0, 1});
  const double s = -1000 * (1 - 2 - std::log((1.02 - 0.5) / (0.02 * 0.5)) / 1.02);
  EXPECT_NEAR(bw.effective.at(s).value, 0.5, 1e-12);
}

TEST(SampledLaws, RefuseLawsThatDoNotGoTogether) {
  EXPECT_THROW(tabulated_soil_water(soil_of(ExponentialRetention{1e3, 0, 1}, BroadbridgeWhitePermeability{}),
                                    test::seed_water()),
               CannotPlan);
  EXPECT_THROW(
      tabulated_soil_water(soil_of(HaverkampRetention{1e3, 2, 0, 1}, MualemPermeability{}), test::seed_water()),
      CannotPlan);
  Soil bare = test::seed_sand(0);
  bare.retention.reset();
  EXPECT_THROW(tabulated_soil_water(bare, test::seed_water()), CannotPlan);
}

}  // namespace
}  // namespace wetfront::mpm
