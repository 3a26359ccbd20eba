// Faults switched on in the candidate only; each must turn at least one verdict of an otherwise passing scene to FAIL.
// The gates proved here are those of verification/cases/seed_column/scene_1.5e-4_smin0.87.toml and
// window_3e-5_smin0.87.toml, and of deforming_column/two_velocities_window.toml.
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace wetfront::verification {
namespace {

using Fault = std::function<void(mpm::Problem<2>&)>;

/// A scene with its references, solved once: a fault is in the candidate alone.
struct Judged {
  Prepared prepared;
  ReferenceRuns reference;
};

Judged judged(const std::string& name) {
  Prepared prepared =
      prepare(read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases" / (name + ".toml")));
  ReferenceRuns reference = solve_references(prepared.scene, prepared.timeline, {});
  return {std::move(prepared), std::move(reference)};
}

/// Half a window shows every fault of a rigid skeleton, and some make it slow.
void halve_window(mpm::Problem<2>& problem) {
  if (problem.stages.size() == 1) return;
  problem.output_times.resize(2);
  problem.stages.back().end_time = problem.output_times.back();
}

/// Names of the quantities that FAIL once the fault is in.
std::set<std::string> failing(const Judged& judged, const Fault& fault) {
  mpm::Problem<2> problem = judged.prepared.problem;
  fault(problem);
  const Histories histories = histories_of(solve_candidate(problem).history, judged.reference);
  const auto measurements = measure(judged.prepared.scene, judged.prepared.timeline, histories);
  std::set<std::string> names;
  for (const auto& finding : judge(judged.prepared.scene, judged.prepared.timeline, measurements, 0))
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

/// One test per scene, so that its references are solved once.
class Faults : public testing::TestWithParam<std::string> {};

TEST_P(Faults, EachIsCaughtAndNoneIsSeenWithoutOne) {
  Judged scene = judged("seed_column/" + GetParam());
  halve_window(scene.prepared.problem);
  EXPECT_TRUE(failing(scene, [](auto&) {}).empty());
  EXPECT_TRUE(failing(scene, rain_times_093).contains("rain_asked"));
  EXPECT_TRUE(failing(scene, misprinted_exponent).contains("pressure_l2"));
  EXPECT_TRUE(failing(scene, doubled_drag).contains("pressure_l2"));
  EXPECT_TRUE(failing(scene, saturation_for_effective_saturation).contains("pressure_l2"));
  EXPECT_TRUE(failing(scene, dropped_gravity).contains("pressure_l2"));
}

INSTANTIATE_TEST_SUITE_P(Seepage, Faults, testing::Values("scene_1.5e-4_smin0.87"),
                         [](const auto&) { return "scene_1_5e_4"; });
INSTANTIATE_TEST_SUITE_P(ImplicitDrag, Faults, testing::Values("window_3e-5_smin0.87"),
                         [](const auto&) { return "window_3e_5"; });

/// Two velocities on a skeleton that deforms, against a reference with the storage of one: a skeleton ten times as
/// stiff stores a tenth of it.
TEST(FaultsOfASkeleton, ItsStorageIsSeenByTwoVelocities) {
  const Judged scene = judged("deforming_column/two_velocities_window");
  EXPECT_TRUE(failing(scene, [](auto&) {}).empty());
  const auto stiff = [](mpm::Problem<2>& problem) { problem.soils[0].elastic->young *= 10; };
  EXPECT_TRUE(failing(scene, stiff).contains("pressure_l2"));
}

}  // namespace
}  // namespace wetfront::verification
