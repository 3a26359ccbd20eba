#include "verification/translate/timeline.h"

#include "verification/scene/read.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"
#include "verification/translate/to_reference.h"

#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

Scene seed_scene(const std::string& name) {
  return read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column" / (name + ".toml"));
}

TEST(Timeline, FillingTimesOfTheSeedColumn) {
  // design/benchmarks.md section 4: 7938 s at 2.78e-5 m/s for S_min 0.087 (7356 s at 3e-5); 1048 s for 0.87 at 3e-5.
  EXPECT_NEAR(*timeline(seed_scene("scene_3e-5")).filling_time, 7938 * 2.78 / 3, 10);
  EXPECT_NEAR(*timeline(seed_scene("scene_3e-5_smin0.87")).filling_time, 1048, 1);
}

TEST(Timeline, RainOnTheStripIsIntensityTimesWidth) {
  const Scene scene = seed_scene("scene_3e-5");
  EXPECT_NEAR(rain_asked(scene, mpm_mesh(scene), 1000), 3e-5 * 0.03 * 1000, 1e-12);
}

TEST(Translate, BothSolversGetTheSameSoilInTheirOwnUnits) {
  const Scene scene = seed_scene("scene_3e-5");
  const Timeline line = timeline(scene);
  const auto mpm = to_mpm(scene, mpm_mesh(scene), line);
  const auto reference = to_reference(scene, line, {50, 0, 1e-6});
  EXPECT_NEAR(reference.soils[0].saturated_conductivity, 2.943e-4, 1e-9);
  EXPECT_NEAR(mpm.soils[0].intrinsic_permeability, 3e-11, 1e-20);
  const auto& curve = std::get<fem_reference::VanGenuchten>(reference.soils[0].retention);
  EXPECT_NEAR(curve.alpha, 2.25517, 1e-5);
  EXPECT_NEAR(curve.n, 2.5641, 1e-4);
  EXPECT_NEAR(curve.theta_r, 0.46 * 0.087, 1e-12);
  EXPECT_NEAR(reference.initial_head.back() * reference.unit_weight, mpm.initial_pressure.back(), 1e-6);
  EXPECT_EQ(reference.output_times, mpm.output_times);
}

TEST(Timeline, ALedgerWithoutRainIsToldPerWidthOfTheGround) {
  Scene scene = seed_scene("scene_3e-5");
  scene.rains.clear();
  EXPECT_NEAR(ledger_area(scene, mpm_mesh(scene)), 0.03, 1e-12);
  EXPECT_EQ(ledger_area(scene, reference_mesh(scene, 10, 0)), 1);
}

TEST(Translate, AnExponentialPermeabilityKeepsAScaleOfItsOwn) {
  Scene scene = seed_scene("scene_3e-5");  // its retention is van Genuchten's: there is no other scale to fall back to
  const Timeline line = timeline(scene);
  scene.soils[0].permeability = PermeabilityLaw::exponential;
  scene.soils[0].permeability_suction_scale = 3000;
  for (const Retention& retention : {scene.soils[0].retention.value(), Retention(Exponential{1000, 0.087, 1})}) {
    scene.soils[0].retention = retention;
    const auto mpm = to_mpm(scene, mpm_mesh(scene), line);
    EXPECT_EQ(std::get<mpm::ExponentialPermeability>(*mpm.soils[0].permeability).suction_scale, 3000);
    const auto reference = to_reference(scene, line, {10, 0, 1e-6});
    EXPECT_NEAR(std::get<fem_reference::ExponentialConductivity>(reference.soils[0].conductivity).alpha, 9810 / 3000.0,
                1e-12);
  }
}

}  // namespace
}  // namespace wetfront::verification
