#include "meshes/gmsh.h"
#include "tests/meshes/shapes.h"
#include "tests/meshes/total_measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace wetfront::meshes {
namespace {

TEST(Generate, LineColumnRunsFromBaseToTop) {
  const Mesh mesh = generate(line_script(1.2, 40), 1);
  ASSERT_EQ(mesh.cell_count(), 40u);
  for (int i = 0; i <= 40; ++i) EXPECT_NEAR(mesh.nodes[i][0], 0.03 * i, 1e-11);  // gmsh spaces to 1e-12
  EXPECT_EQ(mesh.side("base").faces, std::vector<int>{0});
  EXPECT_EQ(mesh.side("top").faces, std::vector<int>{40});
}

TEST(Generate, StripColumnIsOneCellWide) {
  const Mesh mesh = generate(strip_script(1.2, 0.03, 40), 2);
  EXPECT_EQ(mesh.cell_count(), 40u);
  EXPECT_EQ(mesh.node_count(), 82u);
  EXPECT_NEAR(total_measure(mesh), 0.036, 1e-14);
  EXPECT_EQ(mesh.side("top").faces.size(), 2u);
  EXPECT_EQ(mesh.side("left").faces.size(), 80u);
  for (int node : mesh.side("top").faces) EXPECT_NEAR(mesh.nodes[node][1], 1.2, 1e-11);
}

TEST(Generate, SlopeHasItsVerticalThickness) {
  const Mesh mesh = generate(slope_script({10, 1.2, std::numbers::pi / 6, 20, 6}), 2);
  EXPECT_EQ(mesh.cell_count(), 120u);
  EXPECT_NEAR(total_measure(mesh), 12, 1e-9);
}

TEST(Generate, GmshSaysWhatIsWrong) {
  try {
    generate("Plane Surface(1) = {77};\n", 2);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("gmsh failed"));
    EXPECT_THAT(error.what(), testing::HasSubstr("77"));
  }
}

}  // namespace
}  // namespace wetfront::meshes
