/// `--accuracy`: the run refines itself, and the estimate it stops at is honest against the reference.
#include "verification/compare/measure.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

Scene coarse_column() {
  Scene scene =
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column/scene_1.5e-4.toml");
  std::get<Column>(scene.geometry.shape).cells = 10;
  return scene;
}

TEST(Accuracy, CellsAreHalvedUntilTheErrorIsWithinIt) {
  const Scene scene = coarse_column();
  const Timeline line = timeline(scene);
  constexpr double accuracy = 0.01;
  const AccurateCandidate found = solve_to_accuracy(scene, line, accuracy);
  EXPECT_TRUE(found.reached);
  EXPECT_GE(found.tries.size(), 3u);  // ten cells are 5 % off
  EXPECT_GT(found.problem.mesh.cell_count(), 10u);
  EXPECT_LE(found.estimate, accuracy);
  const auto reference = solve_references(scene, line, {});
  const auto measured = measure(scene, line, histories_of(found.solved.history, reference));
  double worst = 0;
  for (const Measurement& m : measured)
    if (m.quantity == "pressure_l2") worst = std::max(worst, m.error);
  EXPECT_LE(worst, accuracy);
  EXPECT_LE(worst, 1.5 * found.estimate);   // the estimate is no flattery ...
  EXPECT_GE(worst, 0.02 * found.estimate);  // ... and no scare: second order leaves a third of the last change
}

/// Twice the cells change nothing that matters: the first mesh is good enough, and is the one that is kept.
TEST(Accuracy, ACoarseMeshThatIsGoodEnoughIsKept) {
  const Scene scene = coarse_column();
  const AccurateCandidate found = solve_to_accuracy(scene, timeline(scene), 0.3);
  EXPECT_TRUE(found.reached);
  EXPECT_EQ(found.problem.mesh.cell_count(), 10u);
}

/// What a tighter tolerance changes is measured on one mesh: cell values against values at the same points, without
/// the error of interpolation, which no tolerance makes smaller and which let the search go on until a run gave up.
TEST(Accuracy, AToleranceIsTightenedOnlyWhereItMatters) {
  const Scene scene =
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column/scene_7.5e-5.toml");
  const AccurateCandidate found = solve_to_accuracy(scene, timeline(scene), 0.005);
  EXPECT_TRUE(found.reached) << found.summary;
  ASSERT_EQ(found.tries.size(), 3u) << "half the cell size, a tenth of the tolerance";
  EXPECT_LT(found.tries[2].change, found.tries[1].change / 4);
}

TEST(Accuracy, OutOfReachIsSaid) {
  Scene scene = coarse_column();
  scene.comparison.times.clear();
  EXPECT_THROW(solve_to_accuracy(scene, timeline(scene), 0.01), SceneError);
  scene = coarse_column();
  scene.geometry.shape = MeshFile{"ground.msh"};
  EXPECT_THROW(solve_to_accuracy(scene, Timeline{}, 0.01), SceneError);
}

}  // namespace
}  // namespace wetfront::verification
