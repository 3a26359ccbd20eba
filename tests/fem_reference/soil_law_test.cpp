#include "fem_reference/soil/soil_law.h"

#include "tests/fem_reference/columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

VanGenuchten with_air_entry(double air_entry) {
  VanGenuchten law{0.08, 0.43, 4.0, 1.6};
  law.air_entry = air_entry;
  return law;
}

/// A law sampled as a laboratory would give it.
Soil tabulated(const Soil& soil, const std::vector<double>& heads) {
  const SoilLaw law(soil);
  TabulatedRetention content{heads, {}};
  TabulatedConductivity relative{heads, {}};
  for (double head : heads) {
    content.content.push_back(law.water_content(head).value);
    relative.relative.push_back(law.conductivity(head).value / soil.saturated_conductivity);
  }
  return {"table of " + soil.name, content, relative, soil.saturated_conductivity, 0, 0};
}

const Soil loam{"loam", VanGenuchten{0.08, 0.43, 4.0, 1.6}, MualemConductivity{}, 5.8e-6, 1e-5, 0};
// Celia et al. 1990 (benchmarks.md 2.1a), centimetres to metres.
const Soil celia_sand{"Haverkamp sand",
                      HaverkampRetention{0.075, 0.287, 1.611e6 * std::pow(0.01, 3.96), 3.96},
                      HaverkampConductivity{1.175e6 * std::pow(0.01, 4.74), 4.74},
                      9.44e-5,
                      0,
                      0};
// Haverkamp et al. 1977.
const Soil yolo_clay{"Yolo clay",
                     HaverkampLogRetention{0.124, 0.495, 739, 4},
                     HaverkampConductivity{124.6 * std::pow(0.01, 1.77), 1.77},
                     1.23e-7,
                     1e-5,
                     0};
const Soil broadbridge{
    "Broadbridge-White", BroadbridgeWhiteRetention{0.1, 0.4, 1.5, 0.2}, BroadbridgeWhiteConductivity{}, 1e-5, 0, 0};

const std::vector<Soil> soils = {
    seed_sand(0.087),
    loam,
    {"Gardner", ExponentialRetention{0.06, 0.40, 10}, ExponentialConductivity{10}, 1e-5, 0, 0},
    {"constant", VanGenuchten{0.1, 0.4, 2, 3}, ConstantConductivity{}, 1e-5, 0, 0},
    {"air entry", with_air_entry(0.1), MualemConductivity{}, 5.8e-6, 1e-5, 0},
    celia_sand,
    yolo_clay,
    // Vauclin, Khanji & Vachaud 1979: theta_r = 0, other constants (cm).
    {"Vauclin", HaverkampRetention{0, 0.30, 4e4 * std::pow(0.01, 2.9), 2.9},
     HaverkampConductivity{2.99e6 * std::pow(0.01, 5.0), 5.0}, 9.72e-5, 0, 0},
    broadbridge,
    tabulated(loam, {-50, -10, -4, -2, -1.1, -0.6, -0.31, -0.1, -0.03, 0}),
};

// Central differences with step 1e-5 |psi| are off by 1e-10 psi^2 times the third derivative, and by rounding; 1e-6
// leaves room for the former and catches any wrong term.
void expect_slope(const Soil& soil, double head, ValueAndSlope (SoilLaw::*law)(double) const) {
  const SoilLaw laws(soil);
  const double step = 1e-5 * std::abs(head);
  const double difference = ((laws.*law)(head + step).value - (laws.*law)(head - step).value) / (2 * step);
  const double rounding = 4e-16 * (laws.*law)(head).value / step;
  EXPECT_NEAR((laws.*law)(head).slope, difference, 1e-6 * std::abs(difference) + rounding)
      << soil.name << " at " << head;
}

TEST(SoilLaw, SlopesAreDerivatives) {
  for (const Soil& soil : soils) {
    for (double head : {-20.0, -3.0, -1.0, -0.3, -0.02, 0.7}) {
      expect_slope(soil, head, &SoilLaw::water_content);
      expect_slope(soil, head, &SoilLaw::storage);
      expect_slope(soil, head, &SoilLaw::conductivity);
    }
  }
}

// benchmarks.md section 4: S(10 kPa) = .3190 and .9030, k_rel(10 kPa) = 2.192e-3 (printed to 4 digits).
TEST(SoilLaw, SeedSandAtTenKilopascal) {
  const double head = -10e3 / unit_weight;
  EXPECT_NEAR(SoilLaw(seed_sand(0.087)).saturation(head), 0.3190, 5e-5);
  EXPECT_NEAR(SoilLaw(seed_sand(0.87)).saturation(head), 0.9030, 5e-5);
  EXPECT_NEAR(SoilLaw(seed_sand(0.087)).conductivity(head).value / 2.943e-4, 2.192e-3, 5e-7);
}

// S_max < 1: the saturation of a soil with trapped air stays below one.
TEST(SoilLaw, PorosityAboveThetaS) {
  Soil soil = seed_sand(0.087);
  soil.porosity = 0.5;
  EXPECT_DOUBLE_EQ(SoilLaw(soil).saturation(1.0), 0.46 / 0.5);
}

// Neither end of the curve may overflow, cancel or turn into NaN.
TEST(SoilLaw, ExtremeHeadsStayFinite) {
  for (const Soil& soil : soils) {
    double last = 2;
    for (double head : {-1e-300, -1e-12, -1e-3, -1.0, -1e3, -1e6}) {
      const ValueAndSlope k = SoilLaw(soil).conductivity(head);
      const ValueAndSlope w = SoilLaw(soil).storage(head);
      EXPECT_TRUE(std::isfinite(k.value) && std::isfinite(k.slope) && k.value >= 0) << soil.name << head;
      EXPECT_TRUE(std::isfinite(w.value) && std::isfinite(w.slope)) << soil.name << head;
      EXPECT_LE(k.value / soil.saturated_conductivity, last) << soil.name << head;
      last = k.value / soil.saturated_conductivity;
    }
  }
}

// benchmarks.md 1.4: psi/lambda of Theta at C = 1.5, printed to 6 to 8 digits; and K by the paper's formula.
TEST(SoilLaw, BroadbridgeWhiteInvertsThePrintedCurve) {
  const SoilLaw law(broadbridge);
  const double psi[] = {-102.798062, -11.22147, -1.924196, -.302899}, se[] = {.01, .1, .5, .9};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR((law.water_content(0.2 * psi[i]).value - 0.1) / 0.3, se[i], 1e-6 * se[i]);
    EXPECT_NEAR(law.conductivity(0.2 * psi[i]).value / 1e-5, 0.5 * se[i] * se[i] / (1.5 - se[i]), 2e-6 * se[i]);
  }
}

// The paper's formulas in centimetres, against the law in metres.
TEST(SoilLaw, HaverkampInCentimetres) {
  const SoilLaw law(celia_sand);
  for (double h : {-61.5, -20.7, -5.0}) {
    const double a = 1.611e6, k = 1.175e6;
    EXPECT_NEAR(law.water_content(0.01 * h).value, 0.075 + a * 0.212 / (a + std::pow(-h, 3.96)), 1e-14);
    EXPECT_NEAR(law.conductivity(0.01 * h).value, 9.44e-5 * k / (k + std::pow(-h, 4.74)), 1e-18);
  }
}

// Full down to the air entry, continuous there, and below it van Genuchten's curve scaled by one number.
TEST(SoilLaw, AirEntryCutsTheTop) {
  const SoilLaw cut(soils[4]), plain(loam);
  EXPECT_EQ(cut.water_content(-0.0999).value, 0.43);
  EXPECT_EQ(cut.conductivity(-0.0999).value, 5.8e-6);
  EXPECT_NEAR(cut.water_content(-0.1 - 1e-12).value, 0.43, 1e-12);
  EXPECT_NEAR(cut.conductivity(-0.1 - 1e-12).value, 5.8e-6, 1e-15);
  const double at_entry = (plain.water_content(-0.1).value - 0.08) / 0.35;
  EXPECT_NEAR(cut.water_content(-2).value - 0.08, (plain.water_content(-2).value - 0.08) / at_entry, 1e-14);
  EXPECT_GT(cut.storage(-0.05).value, 0.43);  // the water is compressed from -air_entry on
}

// Through the points, monotone between them, and near the law that they were taken from: linear interpolation of the
// widest gap (psi -4 to -2 m) would be off by 4e-3 in theta.
TEST(SoilLaw, TableFollowsItsPoints) {
  const SoilLaw table(soils.back()), law(loam);
  for (double head : {-50.0, -2.0, -0.1}) {
    EXPECT_NEAR(table.water_content(head).value, law.water_content(head).value, 1e-15);
    EXPECT_NEAR(table.conductivity(head).value / law.conductivity(head).value, 1, 1e-13);
  }
  EXPECT_NEAR(table.water_content(-2.8).value, law.water_content(-2.8).value, 1e-3);
  double last = 0;
  for (double head = -60; head < 0.1; head += 0.01) {
    EXPECT_GE(table.water_content(head).value, last);
    last = table.water_content(head).value;
  }
  EXPECT_EQ(table.water_content(-60).value, table.water_content(-50).value);
}

}  // namespace
}  // namespace wetfront::fem_reference
