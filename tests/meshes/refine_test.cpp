#include "meshes/refine.h"

#include "meshes/gmsh.h"
#include "tests/meshes/shapes.h"
#include "tests/meshes/total_measure.h"

#include <gtest/gtest.h>

namespace wetfront::meshes {
namespace {

TEST(Refine, HalvesQuadrilateralsAndTheirSides) {
  const Mesh coarse = generate(slope_script({10, 1.2, 0.5, 5, 2}), 2), fine = refined(coarse);
  EXPECT_NO_THROW(validate(fine));
  EXPECT_EQ(fine.cell_count(), 4 * coarse.cell_count());
  EXPECT_EQ(fine.node_count(), 11u * 5u);  // no edge's middle twice
  EXPECT_NEAR(total_measure(fine), total_measure(coarse), 1e-12);
  for (const Side& side : coarse.sides) EXPECT_EQ(fine.side(side.name).faces.size(), 2 * side.faces.size());
}

TEST(Refine, HalvesALine) {
  const Mesh fine = refined(generate(line_script(1.2, 4), 1));
  EXPECT_NO_THROW(validate(fine));
  EXPECT_EQ(fine.cell_count(), 8u);
  EXPECT_NEAR(total_measure(fine), 1.2, 1e-12);
}

/// Two hexahedra side by side, the right one sheared, sides at both ends.
Mesh two_hexahedra() {
  Mesh mesh;
  mesh.dim = 3;
  for (const double x : {0.0, 1.0, 2.5}) {
    for (auto [y, z] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.2, 1.0}, {0.0, 1.0}}) mesh.nodes.push_back({x, y, z});
  }
  mesh.cells = {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11};
  mesh.region = {0, 0};
  mesh.region_names = {"soil"};
  mesh.sides = {{"left", {0, 3, 2, 1}}, {"right", {8, 9, 10, 11}}};
  return mesh;
}

TEST(Refine, HalvesHexahedraAndTheirSides) {
  const Mesh coarse = two_hexahedra(), fine = refined(refined(coarse));
  EXPECT_NO_THROW(validate(fine));
  EXPECT_EQ(fine.cell_count(), 2u * 64u);
  EXPECT_EQ(fine.node_count(), 9u * 5u * 5u);
  EXPECT_NEAR(total_measure(fine), total_measure(coarse), 1e-12);
  for (const Side& side : fine.sides) EXPECT_EQ(side.faces.size(), 16u * 4u);
}

// What nested fields are compared by.
TEST(Refine, PutsPartsAtCornersInOrder) {
  const Mesh coarse = two_hexahedra(), fine = refined(coarse);
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto part = fine.cell(8 * c + i);
      EXPECT_EQ(part[i], coarse.cell(c)[i]);
      for (std::size_t j = 0; j < 8; ++j) EXPECT_EQ(part[j], fine.cell(8 * c + j)[i]);
    }
  }
}

TEST(Refine, KeepsRegions) {
  Mesh coarse = generate(slope_script({2, 1, 0, 2, 1}), 2);
  coarse.region_names = {"left", "right"};
  coarse.region = {0, 1};
  const Mesh fine = refined(coarse);
  for (std::size_t c = 0; c < fine.cell_count(); ++c) EXPECT_EQ(fine.region[c], fine.cell_centre(c)[0] > 1 ? 1 : 0);
}

}  // namespace
}  // namespace wetfront::meshes
