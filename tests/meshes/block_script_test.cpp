/// Ground in blocks: cells follow inner boundaries, sides and their measures are those of the shape; fields in space.
#include "meshes/block_script.h"
#include "meshes/evaluate.h"
#include "meshes/gmsh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wetfront::meshes {
namespace {

double total(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) sum += mesh.cell_measure(c);
  return sum;
}

bool has_node(const Mesh& mesh, const Point& at) {
  return std::ranges::any_of(mesh.nodes, [&](const Point& node) {
    return std::abs(node[0] - at[0]) + std::abs(node[1] - at[1]) + std::abs(node[2] - at[2]) < 1e-9;
  });
}

TEST(Blocks, LineKeepsItsInnerBoundary) {
  const Mesh mesh = generate(blocks_of_line({0, 0.7, 1.2}, {6, 4}), 1);
  EXPECT_EQ(mesh.cell_count(), 10u);
  EXPECT_TRUE(has_node(mesh, {0.7}));
  EXPECT_EQ(mesh.side("top").faces.size(), 1u);
}

/// 4 x 3 m under a surface that rises by 1 m over the second half: 12 + 1 m2.
TEST(Blocks, PlaneFollowsLinesAndVerticals) {
  const Mesh mesh = generate(blocks_in_plane({{0, 2, 4}, {{0, 0, 0}, {1, 1, 1.5}, {3, 3, 4}}, {3, 2}, {2, 4}}), 2);
  EXPECT_EQ(mesh.cell_count(), 30u);
  EXPECT_NEAR(total(mesh), 13, 1e-9);
  EXPECT_TRUE(has_node(mesh, {2, 1}));
  EXPECT_TRUE(has_node(mesh, {4, 1.5}));
  EXPECT_EQ(mesh.side("top").faces.size(), 2u * 5);
  EXPECT_EQ(mesh.side("left").faces.size(), 2u * 6);
}

TEST(Blocks, SpaceHasSixSides) {
  const Mesh mesh = generate(blocks_in_space({{{{0, 1, 2}, {0, 3}, {0, 0.5, 1}}}, {{{2, 1}, {2}, {1, 3}}}}), 3);
  EXPECT_EQ(mesh.cell_count(), 3u * 2 * 4);
  EXPECT_NEAR(total(mesh), 6, 1e-9);
  EXPECT_TRUE(has_node(mesh, {1, 1.5, 0.5}));
  for (const auto& [name, faces] : std::vector<std::pair<std::string, int>>{
           {"left", 8}, {"right", 8}, {"front", 12}, {"back", 12}, {"base", 6}, {"top", 6}})
    EXPECT_EQ(mesh.side(name).faces.size(), 4u * faces) << name;
  for (const int node : mesh.side("top").faces) EXPECT_NEAR(mesh.nodes[node][2], 1, 1e-12);
  for (const int node : mesh.side("front").faces) EXPECT_NEAR(mesh.nodes[node][1], 0, 1e-12);
}

/// A trilinear field is its own interpolant, in a cell that is no parallelepiped too.
TEST(Evaluate, TrilinearFieldsAreExactInSpace) {
  Mesh mesh = generate(blocks_in_space({{{{0, 2}, {0, 1}, {0, 1}}}, {{{4}, {3}, {2}}}}), 3);
  std::vector<double> nodal;
  for (const Point& node : mesh.nodes) nodal.push_back(3 * node[0] - node[1] + 2 * node[0] * node[1] * node[2]);
  const Evaluator evaluate(mesh);
  for (const Point& at : {Point{0.3, 0.7, 0.2}, Point{1.99, 0, 1}, Point{0, 1, 0.5}})
    EXPECT_NEAR(evaluate(nodal, at), 3 * at[0] - at[1] + 2 * at[0] * at[1] * at[2], 1e-12);
  for (Point& node : mesh.nodes) node[2] *= 1 + 0.1 * node[0];
  for (std::size_t i = 0; i < nodal.size(); ++i) nodal[i] = 1 + mesh.nodes[i][0] - 2 * mesh.nodes[i][1];
  const Evaluator sheared(mesh);
  EXPECT_NEAR(sheared(nodal, {1.3, 0.4, 1.05}), 1 + 1.3 - 0.8, 1e-12);
  EXPECT_THROW(sheared(nodal, {1.3, 0.4, 1.2}), std::out_of_range);
}

}  // namespace
}  // namespace wetfront::meshes
