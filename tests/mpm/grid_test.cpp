// Stencils on skewed cells, places and cells, seeding.
#include "mpm/grid/cell_moments.h"
#include "mpm/grid/cell_values.h"
#include "mpm/grid/seeding.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

namespace wetfront::mpm {
namespace {

meshes::Mesh skewed_quads() {
  meshes::Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1.3, 0.2, 0}, {2.1, -0.1, 0}, {-0.2, 0.9, 0}, {1.0, 1.4, 0}, {2.6, 1.1, 0}};
  mesh.cells = {0, 1, 4, 3, 1, 2, 5, 4};
  mesh.region = {0, 0};
  mesh.region_names = {"soil"};
  return mesh;
}

meshes::Mesh skewed_brick() {
  meshes::Mesh mesh;
  mesh.dim = 3;
  mesh.nodes = {{0, 0, 0},     {1.2, 0.1, 0}, {1.1, 1.3, 0.1},  {-.1, 1, 0},
                {0.1, 0, 0.9}, {1.3, 0, 1.1}, {1.2, 1.1, 1.25}, {0, 1.1, 1}};
  mesh.cells = {0, 1, 2, 3, 4, 5, 6, 7};
  mesh.region = {0};
  mesh.region_names = {"soil"};
  return mesh;
}

template <int dim>
void expect_linear_completeness(const Grid<dim>& grid, std::size_t cell, const Vector<dim>& xi) {
  Stencil<dim> s;
  grid.stencil(cell, xi, s);
  const Vector<dim> x = grid.place(cell, xi);
  double one = 0;
  Vector<dim> place{}, zero{};
  std::array<Vector<dim>, dim> identity{};
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    const auto& node = grid.node(grid.cell_nodes_of(cell)[i]);
    one += s.value[i];
    for (int a = 0; a < dim; ++a) {
      place[a] += s.value[i] * node[a];
      zero[a] += s.gradient[i][a];
      for (int b = 0; b < dim; ++b) identity[a][b] += node[a] * s.gradient[i][b];
    }
  }
  EXPECT_NEAR(one, 1, 1e-14);
  for (int a = 0; a < dim; ++a) {
    EXPECT_NEAR(place[a], x[a], 1e-14);
    EXPECT_NEAR(zero[a], 0, 1e-14);
    for (int b = 0; b < dim; ++b) EXPECT_NEAR(identity[a][b], a == b, 1e-13);
    EXPECT_NEAR(grid.local(cell, x)[a], xi[a], 1e-12);
  }
}

TEST(Stencil, IsCompleteOnSkewedQuads) {
  const Grid<2> grid(skewed_quads());
  EXPECT_FALSE(grid.affine(0));
  for (double u : {-0.9, 0.1, 0.6})
    for (double v : {-0.7, 0.3, 1.0})
      for (std::size_t cell : {0, 1}) expect_linear_completeness<2>(grid, cell, {u, v});
}

TEST(Stencil, IsCompleteOnASkewedBrick) {
  const Grid<3> grid(skewed_brick());
  for (double u : {-0.9, 0.6})
    for (double v : {-0.7, 0.3})
      for (double w : {-0.2, 0.8}) expect_linear_completeness<3>(grid, 0, {u, v, w});
}

TEST(Stencil, AffineCellsTakeTheFastPathAndAgree) {
  meshes::Mesh mesh = skewed_quads();
  mesh.nodes[4] = {1.1, 1.1, 0};  // makes cell 0 a parallelogram
  const Grid<2> grid(mesh);
  EXPECT_TRUE(grid.affine(0));
  EXPECT_FALSE(grid.affine(1));
  expect_linear_completeness<2>(grid, 0, {0.3, -0.8});
}

TEST(Grid, FindsCellsFromNearAndFar) {
  const Grid<2> grid(test::strip(1.2, 40));
  EXPECT_EQ(grid.find_cell({0.01, 0.031}, 0), 1);
  EXPECT_EQ(grid.find_cell({0.01, 1.19}, 0), 39);
  EXPECT_EQ(grid.find_cell({0.01, 1.21}, 39), -1);
  EXPECT_NEAR(grid.smallest_altitude(7), 0.03, 1e-14);
}

template <int dim>
void expect_moments_of_stencils() {
  const std::array<Vector<dim>, 3> places = {Vector<dim>{0.3, -0.8}, Vector<dim>{-0.9, 0.1}, Vector<dim>{0.5, 0.6}};
  const std::array<double, 3> weight = {2, -0.7, 1.3};
  CellMoments<dim> moments;
  std::array<double, cell_nodes<dim>> value{};
  std::array<Vector<dim>, cell_nodes<dim>> slope{};
  for (std::size_t k = 0; k < 3; ++k) {
    Vector<dim> xi = places[k];
    if (dim == 3) xi[dim - 1] = 0.4 - 0.3 * static_cast<double>(k);
    moments.add(xi, weight[k]);
    Stencil<dim> s;
    reference_stencil<dim>(xi, s);
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      value[i] += weight[k] * s.value[i];
      for (int a = 0; a < dim; ++a) slope[i][a] += weight[k] * s.gradient[i][a];
    }
  }
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    EXPECT_NEAR(moments.value(i), value[i], 1e-15) << i;
    for (int a = 0; a < dim; ++a) EXPECT_NEAR(moments.slope(i)[a], slope[i][a], 1e-15) << i << a;
  }
}

TEST(CellMoments, GiveTheSumsOfEveryPointsStencil) {
  expect_moments_of_stencils<2>();
  expect_moments_of_stencils<3>();
}

TEST(CellValues, KnowNothingOfNodesAboveTheGround) {
  const Grid<2> grid(test::strip(1.0, 10));
  std::vector<double> pressure;
  for (std::size_t i = 0; i < grid.node_count(); ++i) {
    const double y = grid.node(static_cast<int>(i))[1];
    pressure.push_back(y < 0.65 ? 1e3 * y * y : -7e4);  // soil up to y = 0.6
  }
  const std::vector<double> values =
      cell_values<2>(grid, pressure.data(), [](std::size_t cell) { return cell < 6 ? 0 : -1; });
  for (std::size_t cell = 1; cell < 6; ++cell) {
    const double y = grid.place(cell, {})[1], h = 0.1;
    // Quadratic fields are met inside; beside the ground's surface, where gradients are one-sided, within h2/8 p''.
    EXPECT_NEAR(values[cell], 1e3 * y * y, cell < 5 ? 1e-9 : 2e3 * h * h / 8) << cell;
  }
}

TEST(Seeding, GaussPointsFillTheCellsExactly) {
  const Grid<2> grid(skewed_quads());
  for (int per_cell : {1, 4, 9, 16, 25}) {
    auto points = seed<2>(grid, per_cell);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(2 * per_cell));
    double area = 0;
    for (double v : points.columns.at("volume").values()) area += v;
    // Shoelace area of the two cells; the Jacobian of a bilinear map is linear, any Gauss rule is exact.
    EXPECT_NEAR(area, 1.40 + 1.47, 1e-12) << per_cell;
  }
  EXPECT_THROW(seed<2>(grid, 5), CannotPlan);
}

TEST(Seeding, FourPointsSitAtTheTwoPointGaussPlaces) {
  const Grid<2> grid(test::strip(1.2, 40));
  const auto points = seed<2>(grid, 4);
  EXPECT_NEAR(points.position(0)[1], 0.015 * (1 - 1 / std::sqrt(3.0)), 1e-15);
  EXPECT_NEAR(points.position(159)[1], 1.2 - 0.015 * (1 - 1 / std::sqrt(3.0)), 1e-14);
}

}  // namespace
}  // namespace wetfront::mpm
