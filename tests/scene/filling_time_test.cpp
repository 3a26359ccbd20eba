#include "verification/scene/filling_time.h"

#include "verification/scene/read.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace wetfront::verification {
namespace {

Scene seed(const std::string& name) {
  return read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column" / name);
}

/// Gardner's curve from hydrostatic without a cap integrates in closed form:
///   n (S_max - S_min) [H - (p_c / gamma) (1 - exp(-gamma H / p_c))] / I.
TEST(FillingTime, ClosedFormOfTheExponentialCurve) {
  Scene scene = seed("scene_3e-5.toml");
  const double scale = 981, weight = 9810, height = 1.2;
  scene.soils[0].retention = Exponential{scale, 0.1, 1.0};
  std::get<HydrostaticStart>(scene.initial->pressure).suction_cap = INFINITY;
  const double exact = 0.46 * 0.9 * (height + scale / weight * std::expm1(-weight * height / scale)) / 3e-5;
  EXPECT_NEAR(*filling_time(scene).seconds / exact, 1, 1e-6);  // the midpoint sum's own bound, filling_time.cpp
}

/// The project's issue gives 1048 s for the printed S_min = 0.87 and asks for 0.5 %.
TEST(FillingTime, SeedColumnWithThePrintedResidualSaturation) {
  EXPECT_NEAR(*filling_time(seed("scene_3e-5_smin0.87.toml")).seconds, 1048, 0.005 * 1048);
}

/// 7938 s at 2.78e-5 m/s (100 mm/h), computed independently: the deficit is the same at any intensity.
TEST(FillingTime, SeedColumn) {
  EXPECT_NEAR(*filling_time(seed("scene_3e-5.toml")).seconds * 3e-5 / (0.1 / 3600), 7938, 0.001 * 7938);
}

TEST(FillingTime, SaysWhyThereIsNone) {
  Scene scene = seed("scene_3e-5.toml");
  scene.boundaries[0].water = WaterCondition::free_drainage;
  EXPECT_EQ(filling_time(scene).why_not, "water passes through 'base'");
  scene = seed("scene_3e-5.toml");
  scene.rains[0].record = {{0, 3600}, {1e-5, 0}};
  EXPECT_EQ(filling_time(scene).why_not, "the rain varies in time");
  scene.rains.clear();
  EXPECT_EQ(filling_time(scene).why_not, "there is no rain");
}

}  // namespace
}  // namespace wetfront::verification
