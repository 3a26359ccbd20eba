#include "fem_reference/soil_law.h"

#include "tests/fem_reference/columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

const std::vector<Soil> soils = {
    seed_sand(0.087),
    {"loam", VanGenuchten{0.08, 0.43, 4.0, 1.6}, MualemConductivity{}, 5.8e-6, 1e-5, 0},
    {"Gardner", ExponentialRetention{0.06, 0.40, 10}, ExponentialConductivity{10}, 1e-5, 0, 0},
    {"constant", VanGenuchten{0.1, 0.4, 2, 3}, ConstantConductivity{}, 1e-5, 0, 0},
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

}  // namespace
}  // namespace wetfront::fem_reference
