// Faults switched on in the candidate only; each must turn at least one verdict of an otherwise passing scene to FAIL.
// The gates proved here are those of verification/cases/seed_column/scene_1.5e-4_smin0.87.toml and the window scene.
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace wetfront::verification {
namespace {

using Fault = std::function<void(mpm::Problem<2>&)>;

Prepared seed(const std::string& name) {
  return prepare(
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column" / (name + ".toml")));
}

/// Names of the quantities that FAIL once the fault is in.
std::set<std::string> failing(const std::string& scene, const Fault& fault) {
  Prepared prepared = seed(scene);
  fault(prepared.problem);
  std::set<std::string> names;
  for (const auto& finding : run_prepared(prepared).record.findings)
    if (finding.verdict == reports::Verdict::fail) names.insert(finding.quantity);
  return names;
}

void rain_times_093(mpm::Problem<2>& problem) {
  for (auto& boundary : problem.water_boundary)
    if (auto* rain = std::get_if<mpm::RainSide>(&boundary))
      for (double& intensity : rain->rain.intensity) intensity *= 0.93;
}

void misprinted_exponent(mpm::Problem<2>& problem) {
  for (auto& soil : problem.soils) soil.permeability = mpm::PrintedMualemPermeability{};
}

void doubled_drag(mpm::Problem<2>& problem) {
  for (auto& soil : problem.soils) soil.intrinsic_permeability /= 2;
}

void saturation_for_effective_saturation(mpm::Problem<2>& problem) {
  for (auto& soil : problem.soils) soil.permeability = mpm::MualemOfSaturationPermeability{};
}

void dropped_gravity(mpm::Problem<2>& problem) {
  problem.gravity = {0, 0};
}

class Faults : public testing::TestWithParam<std::string> {};

TEST_P(Faults, NoneIsReportedWithoutAFault) {
  EXPECT_TRUE(failing(GetParam(), [](auto&) {}).empty());
}

TEST_P(Faults, RainTimes093IsCaughtByTheAudit) {
  const auto names = failing(GetParam(), rain_times_093);
  EXPECT_TRUE(names.contains("rain_asked"));
}

TEST_P(Faults, MisprintedMualemExponentIsCaughtByThePressure) {
  EXPECT_TRUE(failing(GetParam(), misprinted_exponent).contains("pressure_l2"));
}

TEST_P(Faults, DoubledDragIsCaughtByThePressure) {
  EXPECT_TRUE(failing(GetParam(), doubled_drag).contains("pressure_l2"));
}

TEST_P(Faults, SaturationForEffectiveSaturationIsCaughtByThePressure) {
  EXPECT_TRUE(failing(GetParam(), saturation_for_effective_saturation).contains("pressure_l2"));
}

TEST_P(Faults, DroppedGravityIsCaughtByThePressure) {
  EXPECT_TRUE(failing(GetParam(), dropped_gravity).contains("pressure_l2"));
}

INSTANTIATE_TEST_SUITE_P(Seepage, Faults, testing::Values("scene_1.5e-4_smin0.87"),
                         [](const auto&) { return "scene_1_5e_4"; });
INSTANTIATE_TEST_SUITE_P(ImplicitDrag, Faults, testing::Values("window_1.5e-4_smin0.87"),
                         [](const auto&) { return "window_1_5e_4"; });

}  // namespace
}  // namespace wetfront::verification
