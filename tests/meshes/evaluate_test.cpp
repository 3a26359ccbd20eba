#include "meshes/evaluate.h"

#include <gtest/gtest.h>

namespace wetfront::meshes {
namespace {

/// Two skewed quadrilaterals side by side.
Mesh skewed_pair() {
  Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0.1, 0}, {2.2, 0, 0}, {0.1, 1, 0}, {1.2, 1.3, 0}, {2, 1.1, 0}};
  mesh.cells = {0, 1, 4, 3, 1, 2, 5, 4};
  mesh.region = {0, 0};
  mesh.region_names = {"soil"};
  return mesh;
}

std::vector<double> linear_field(const Mesh& mesh) {
  std::vector<double> field;
  for (const Point& x : mesh.nodes) field.push_back(3 + 2 * x[0] - 5 * x[1]);
  return field;
}

TEST(Evaluate, ReproducesLinearFieldsOnSkewedQuadrilaterals) {
  const Mesh mesh = skewed_pair();
  const Evaluator evaluate(mesh);
  const auto field = linear_field(mesh);
  for (const Point at : {Point{0.5, 0.5, 0}, Point{1.1, 0.7, 0}, Point{1.9, 0.4, 0}, mesh.nodes[4]})
    EXPECT_NEAR(evaluate(field, at), 3 + 2 * at[0] - 5 * at[1], 1e-12);
}

TEST(Evaluate, InterpolatesOnALine) {
  Mesh line;
  line.dim = 1;
  line.nodes = {{0, 0, 0}, {0.5, 0, 0}, {2, 0, 0}};
  line.cells = {0, 1, 1, 2};
  line.region = {0, 0};
  line.region_names = {"soil"};
  const Evaluator evaluate(line);
  EXPECT_DOUBLE_EQ(evaluate({1, 3, 0}, {0.25}), 2);
  EXPECT_DOUBLE_EQ(evaluate({1, 3, 0}, {1.0}), 2);
  EXPECT_DOUBLE_EQ(evaluate({1, 3, 0}, {2.0}), 0);
}

TEST(Evaluate, APointOutsideIsAnError) {
  const Mesh mesh = skewed_pair();
  EXPECT_THROW(Evaluator(mesh).weights({3, 0.5, 0}), std::out_of_range);
  EXPECT_THROW(Evaluator(mesh).weights({1, 2.0, 0}), std::out_of_range);
}

}  // namespace
}  // namespace wetfront::meshes
