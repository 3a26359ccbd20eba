#include "verification/compare/profile.h"

#include "meshes/gmsh.h"
#include "tests/meshes/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

TEST(Profile, RelativeL2IsWeightedByVolume) {
  EXPECT_NEAR(relative_l2({1, 3}, {1, 2}, {1, 1}), 1 / std::sqrt(5.0), 1e-15);
  EXPECT_NEAR(relative_l2({1, 3}, {1, 2}, {4, 1}), 1 / std::sqrt(8.0), 1e-15);
}

TEST(Profile, InfinityNormTakesTheWorstOfEitherSign) {
  EXPECT_DOUBLE_EQ(relative_linf({1, -3, 2}, {1, -2, 2}, {1, 1, 1}), 0.5);
  EXPECT_TRUE(std::isinf(relative_linf({std::nan(""), 1}, {1, 1}, {1, 1})));
}

TEST(Profile, FrontLiesWhereSaturationIsHalfWay) {
  const std::vector<double> elevation = {0.1, 0.2, 0.3, 0.4, 0.5};
  EXPECT_NEAR(front_elevation({1.0, 0.3, 0.3, 0.7, 0.7}, elevation), 0.35, 1e-15);
  EXPECT_TRUE(std::isnan(front_elevation({1.0, 0.9, 0.5, 0.4, 0.3}, elevation)));  // before the rain
  EXPECT_TRUE(std::isnan(front_elevation({1.0, 0.9, 0.8, 0.7, 0.7}, elevation)));  // met the water table
}

TEST(Profile, AOneDimensionalSolutionIsReadAtTheCellsElevation) {
  meshes::FieldHistory line;
  line.mesh = meshes::generate(meshes::line_script(1.0, 10), 1);
  meshes::Snapshot snapshot;
  for (const auto& node : line.mesh.nodes) {
    snapshot.node_pressure.push_back(100 * node[0]);
    snapshot.node_saturation.push_back(node[0]);
  }
  line.snapshots = {snapshot};
  meshes::FieldHistory strip;
  strip.mesh = meshes::generate(meshes::strip_script(1.0, 0.2, 5), 2);
  strip.snapshots.resize(1);
  const auto profiles = profiles_at_cells(line, strip);
  for (std::size_t c = 0; c < strip.mesh.cell_count(); ++c)
    EXPECT_NEAR(profiles[0].pressure[c], 100 * strip.mesh.cell_centre(c)[1], 1e-9);
}

/// A background grid that reaches above the ground: its uppermost cell and nodes are not compared, whatever they hold.
TEST(Profile, CellsAndNodesAboveTheGroundHaveNoWeight) {
  const meshes::Mesh line = meshes::generate(meshes::line_script(0.88, 11), 1);
  const meshes::Mesh strip = meshes::generate(meshes::strip_script(1.0, 0.2, 5), 2);
  const auto cells = cell_weights(strip, line), nodes = node_weights(strip, line);
  std::vector<double> value(5, 1), other(5, 1);
  for (std::size_t c = 0; c < 5; ++c) {
    EXPECT_NEAR(cells[c], strip.cell_centre(c)[1] < 0.88 ? 0.04 : 0, 1e-9);  // gmsh's nodes are 1e-12 off
    if (cells[c] == 0) value[c] = std::nan("");
  }
  for (std::size_t i = 0; i < strip.node_count(); ++i) EXPECT_EQ(nodes[i], strip.nodes[i][1] < 0.88 ? 1 : 0);
  EXPECT_EQ(relative_l2(value, other, cells), 0);
  EXPECT_EQ(relative_linf(value, other, cells), 0);
}

TEST(Profile, CellAveragesAreComparedWithAverages) {
  meshes::FieldHistory line, strip;
  line.mesh = meshes::generate(meshes::line_script(1.0, 80), 1);
  strip.mesh = meshes::generate(meshes::strip_script(1.0, 0.2, 5), 2);
  strip.snapshots.resize(2);
  strip.snapshots[1].cells_hold_averages = true;
  meshes::Snapshot parabola;
  for (const auto& node : line.mesh.nodes) parabola.node_pressure.push_back(node[0] * node[0]);
  parabola.node_saturation = parabola.node_pressure;
  line.snapshots = {parabola, parabola};
  const auto profiles = profiles_at_cells(line, strip);
  const double h = 0.2, y = strip.mesh.cell_centre(2)[1];
  EXPECT_NEAR(profiles[0].pressure[2], y * y, 1e-5);
  EXPECT_NEAR(profiles[1].pressure[2], y * y + h * h / 12, h * h / 12 / 30);  // the midpoints leave 1/64
}

}  // namespace
}  // namespace wetfront::verification
