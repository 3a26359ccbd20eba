#include "meshes/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace wetfront::meshes {
namespace {

Mesh unit_square() {
  Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.cells = {0, 1, 2, 3};
  mesh.region = {0};
  mesh.region_names = {"soil"};
  mesh.sides = {{"top", {2, 3}}};
  return mesh;
}

Mesh unit_cube() {
  Mesh mesh;
  mesh.dim = 3;
  for (double z : {0.0, 1.0})
    for (const Point& corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}})
      mesh.nodes.push_back({corner[0], corner[1], z});
  mesh.cells = {0, 1, 2, 3, 4, 5, 6, 7};
  mesh.region = {0};
  mesh.region_names = {"soil"};
  return mesh;
}

void expect_invalid(const Mesh& mesh, const std::string& why) {
  try {
    validate(mesh);
    FAIL() << "accepted; expected: " << why;
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(why));
  }
}

TEST(Mesh, MeasuresAndCentres) {
  EXPECT_DOUBLE_EQ(unit_square().cell_measure(0), 1);
  EXPECT_DOUBLE_EQ(unit_cube().cell_measure(0), 1);
  EXPECT_DOUBLE_EQ(unit_cube().cell_centre(0)[2], 0.5);
}

TEST(Mesh, SoundMeshesPass) {
  EXPECT_NO_THROW(validate(unit_square()));
  EXPECT_NO_THROW(validate(unit_cube()));
}

TEST(Mesh, UnknownSideNamesTheKnownOnes) {
  try {
    unit_square().side("roof");
    FAIL();
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "the mesh has no side 'roof' (it has: top)");
  }
}

TEST(Mesh, DefectsAreNamed) {
  Mesh inverted = unit_square();
  inverted.cells = {0, 3, 2, 1};
  expect_invalid(inverted, "cell 0 is inverted");
  Mesh dangling = unit_square();
  dangling.cells[2] = 7;
  expect_invalid(dangling, "cell 0 uses node 7, which does not exist");
  Mesh diagonal = unit_square();
  diagonal.sides[0].faces = {0, 2};
  expect_invalid(diagonal, "face 0 of side 'top' is not the face of a cell");
}

}  // namespace
}  // namespace wetfront::meshes
