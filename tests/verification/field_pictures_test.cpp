#include "verification/present/field_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wetfront::verification {
namespace {

/// `across` x `up` cells of 1 m with the pressure `level - 10 y` kPa and saturation 1.
meshes::FieldHistory block(int across, int up, double level) {
  meshes::FieldHistory made;
  made.mesh.dim = 2;
  meshes::Snapshot snapshot;
  snapshot.time = 7;
  const auto node = [across](int i, int j) { return j * (across + 1) + i; };
  for (int j = 0; j <= up; ++j)
    for (int i = 0; i <= across; ++i) {
      made.mesh.nodes.push_back({double(i), double(j), 0});
      snapshot.node_pressure.push_back(1e3 * (level - 10 * j));
      snapshot.node_saturation.push_back(1);
    }
  for (int j = 0; j < up; ++j)
    for (int i = 0; i < across; ++i) {
      for (const int corner : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)})
        made.mesh.cells.push_back(corner);
      made.mesh.region.push_back(0);
    }
  made.snapshots = {snapshot};
  return made;
}

TEST(FieldPictures, ShowBothSolversAndTheirDifference) {
  const auto pictures = field_pictures({block(3, 2, 21), block(3, 2, 20), {}, {}, {}});
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_EQ(pictures[0].id, "pressure_field");
  ASSERT_EQ(pictures[0].panels.size(), 3u);
  ASSERT_EQ(pictures[0].panels[0].nodal.size(), 12u);
  EXPECT_NEAR(pictures[0].panels[0].nodal[0], 21, 1e-12);
  EXPECT_NEAR(pictures[0].panels[1].nodal[0], 20, 1e-12);
  for (const double difference : pictures[0].panels[2].nodal) EXPECT_NEAR(difference, 1, 1e-12);
}

TEST(FieldPictures, OfOneSolutionHaveOnePanel) {
  const auto pictures = field_pictures(block(3, 2, 20), "MPM");
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_EQ(pictures[1].panels.size(), 1u);
}

TEST(FieldPictures, AreNotMadeOfAStrip) {
  EXPECT_TRUE(field_pictures(block(1, 9, 20), "MPM").empty());
  EXPECT_TRUE(field_pictures(block(9, 1, 20), "MPM").empty());
  EXPECT_TRUE(field_pictures({block(1, 9, 21), block(1, 9, 20), {}, {}, {}}).empty());
}

}  // namespace
}  // namespace wetfront::verification
