// Cells that a surface cuts: how they are filled, and how the surface is found again from the points.
#include "mpm/boundary/surface.h"

#include "mpm/grid/seeding.h"
#include "mpm/problem.h"
#include "tests/mpm/plane.h"

#include <gtest/gtest.h>

#include <random>

namespace wetfront::mpm {
namespace {

struct Case {
  const char* name;
  meshes::Mesh mesh;
  std::vector<meshes::Point> line;  ///< over x = 0 to 2
  bool kinked = false;
};

std::vector<Case> cases() {
  const auto level = [](double y) { return std::vector<meshes::Point>{{0, y, 0}, {2, y, 0}}; };
  const std::vector<meshes::Point> slope{{0, 0.2, 0}, {2, 0.2 + 2 * std::tan(0.3), 0}};
  const std::vector<meshes::Point> kinks{{0, 0.3, 0}, {0.53, 0.31, 0}, {1.01, 0.77, 0}, {1.37, 0.52, 0}, {2, 0.61, 0}};
  return {{"level", test::box(2, 1, 12, 8), level(0.555), false},
          {"sliver", test::box(2, 1, 12, 8), level(0.5 + 0.02 / 8), false},
          {"slope", test::box(2, 1, 12, 8), slope, false},
          {"slope through skewed cells", test::crooked_box(2, 1, 12, 8), slope, false},
          {"level through skewed cells", test::crooked_box(2, 1, 12, 8), level(0.61), false},
          {"kinks", test::box(2, 1, 12, 8), kinks, true},
          {"kinks through skewed cells", test::crooked_box(2, 1, 12, 8), kinks, true}};
}

double area_below(const std::vector<meshes::Point>& line) {
  double area = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    area += 0.5 * (line[k][1] + line[k + 1][1]) * (line[k + 1][0] - line[k][0]);
  return area;
}

double height_at(const std::vector<meshes::Point>& line, double x) {
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    if (x <= line[k + 1][0])
      return line[k][1] + (line[k + 1][1] - line[k][1]) * (x - line[k][0]) / (line[k + 1][0] - line[k][0]);
  return line.back()[1];
}

TEST(Seeding, FillsExactlyWhatTheSurfaceLeaves) {
  for (const Case& c : cases())
    for (int per_cell : {1, 4, 9}) {
      const Grid<2> grid(c.mesh);
      const auto points = seed<2>(grid, per_cell, c.line);
      double volume = 0, moment = 0;
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Vector<2> x = points.position(p);
        EXPECT_GT((*points.columns.find("volume"))[0][p], 0);
        EXPECT_LT(x[1], height_at(c.line, x[0]));
        volume += (*points.columns.find("volume"))[0][p];
        moment += (*points.columns.find("volume"))[0][p] * x[1];
      }
      EXPECT_NEAR(volume, area_below(c.line), 1e-13) << c.name << ", " << per_cell;  // round-off
      double exact = 0;  // integral of y: a trapezium's is the integral of height^2/2
      for (std::size_t k = 0; k + 1 < c.line.size(); ++k) {
        const double a = c.line[k][1], b = c.line[k + 1][1];
        exact += (c.line[k + 1][0] - c.line[k][0]) * (a * a + a * b + b * b) / 6;
      }
      // One point per whole skewed cell sits at the middle of its map, not at its centroid.
      EXPECT_NEAR(moment, exact, per_cell > 1 ? 1e-13 : 2e-3) << c.name << ", " << per_cell;
      for (const Block& block : points.blocks())
        for (std::size_t p = block.first; p < block.first + block.count; ++p)
          for (double xi : grid.local(block.cell, points.position(p))) EXPECT_LE(std::abs(xi), 1 + 1e-12);
    }
}

TEST(Seeding, RefusesASurfaceThatLeavesNoSoilOrGoesBack) {
  const Grid<2> grid(test::box(2, 1, 4, 4));
  EXPECT_THROW(seed<2>(grid, 4, {{0, -1, 0}, {2, -1, 0}}), CannotPlan);
  EXPECT_THROW(seed<2>(grid, 4, {{0, 0.5, 0}, {2, 0.5, 0}, {1, 0.7, 0}}), CannotPlan);
  EXPECT_EQ(seed<2>(grid, 4, {{0, 2, 0}, {2, 2, 0}}).size(), 64u);
}

struct Sums {
  Vector<2> all{}, free{};
  double facing_sky = 0, line = 0;
  std::size_t cuts = 0;
};

Sums sums_of(const Surface<2>& surface) {
  Sums sums;
  for (const auto& piece : surface.pieces()) {
    for (std::size_t a = 0; a < 2; ++a) {
      sums.all[a] += piece.area[a];
      if (!piece.border) sums.free[a] += piece.area[a];
    }
    if (!piece.border) sums.facing_sky += std::max(piece.area[1], 0.0);
    sums.cuts += piece.face < 0 ? 1 : 0;
    double weight = 0;
    for (double w : piece.weight) weight += w;
    EXPECT_NEAR(weight, 1, 1e-14);
  }
  return sums;
}

TEST(Surface, ClosesAndIsAsWideAsTheBody) {
  for (const Case& c : cases()) {
    const Grid<2> grid(c.mesh);
    const auto points = seed<2>(grid, 4, c.line);
    Surface<2> surface(grid, points, c.mesh);
    ASSERT_TRUE(surface.update());
    EXPECT_FALSE(surface.update());  // nothing moved, nothing done
    const Sums sums = sums_of(surface);
    for (double component : sums.all) EXPECT_NEAR(component, 0, 1e-12) << c.name;
    EXPECT_NEAR(sums.free[1], 2, 1e-12) << c.name;
    // Pieces that face down would make the rained width larger than the body's.
    EXPECT_NEAR(sums.facing_sky, 2, 1e-12) << c.name;
  }
}

TEST(Surface, FindsAStraightLineAgainOnAnyMesh) {
  for (const Case& c : cases()) {
    if (c.kinked) continue;
    const Grid<2> grid(c.mesh);
    const auto points = seed<2>(grid, 4, c.line);
    Surface<2> surface(grid, points, c.mesh);
    surface.update();
    const Vector<2> along{c.line[1][0] - c.line[0][0], c.line[1][1] - c.line[0][1]};
    for (const auto& piece : surface.pieces()) {
      if (piece.face >= 0) continue;
      EXPECT_NEAR(piece.centre[1], height_at(c.line, piece.centre[0]), 1e-9) << c.name;
      const double size = std::hypot(piece.area[0], piece.area[1]);
      EXPECT_NEAR((piece.area[0] * along[0] + piece.area[1] * along[1]) / size, 0, 1e-6) << c.name;
      // The weights interpolate the surface's own place.
      for (std::size_t a = 0; a < 2; ++a) {
        double x = 0;
        for (int i = 0; i < 4; ++i) x += piece.weight[i] * grid.node(grid.cell_nodes_of(piece.cell)[i])[a];
        EXPECT_NEAR(x, piece.centre[a], 1e-12);
      }
    }
    EXPECT_GE(sums_of(surface).cuts, 12u);
  }
}

TEST(Surface, FullCellsGiveTheirFacesAndBordersTheirSides) {
  const auto mesh = test::box(2, 1, 8, 4);
  const Grid<2> grid(mesh);
  const auto points = seed<2>(grid, 4, {{0, 0.5, 0}, {1, 0.5, 0}, {1, 1, 0}, {2, 1, 0}});  // a step up to the top
  Surface<2> surface(grid, points, mesh);
  surface.update();
  double free_width = 0, cliff = 0;
  std::vector<double> on_side(4, 0.0);
  for (const auto& piece : surface.pieces()) {
    EXPECT_GE(piece.face, 0);
    if (piece.border) {
      ASSERT_GE(piece.side, 0);
      on_side[static_cast<std::size_t>(piece.side)] += std::hypot(piece.area[0], piece.area[1]);
    } else {
      free_width += piece.area[1];
      cliff += std::abs(piece.area[0]);
    }
  }
  EXPECT_NEAR(free_width, 1, 1e-14);
  EXPECT_NEAR(cliff, 0.5, 1e-14);
  const std::vector<double> expected{2, 1, 1, 0.5};  // base, right, top, left
  for (std::size_t s = 0; s < 4; ++s) EXPECT_NEAR(on_side[s], expected[s], 1e-14);
}

TEST(Surface, DoesNotChatterWhenPointsShake) {
  for (const Case& c : cases()) {
    const Grid<2> grid(c.mesh);
    auto points = seed<2>(grid, 4, c.line);
    Surface<2> surface(grid, points, c.mesh);
    surface.update();
    const auto before = surface.pieces();
    Column& position = *points.columns.find("position");
    Column& volume = *points.columns.find("volume");
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shake(-1, 1);
    const std::vector<double> place(position.values().begin(), position.values().end()),
        size(volume.values().begin(), volume.values().end());
    int changes = 0;
    double most = 0;
    for (int round = 0; round < 50; ++round) {
      // A hundredth of a point's share of a cell, and strains of 1e-3.
      for (std::size_t k = 0; k < place.size(); ++k)
        position.values()[k] = place[k] + 0.01 * std::sqrt(size[k % size.size()]) * shake(random);
      for (std::size_t k = 0; k < size.size(); ++k) volume.values()[k] = size[k] * (1 + 1e-3 * shake(random));
      EXPECT_TRUE(surface.update());
      changes += surface.pieces().size() != before.size() ? 1 : 0;
      if (surface.pieces().size() == before.size())
        for (std::size_t k = 0; k < before.size(); ++k) {
          changes += before[k].cell != surface.pieces()[k].cell || before[k].face != surface.pieces()[k].face ? 1 : 0;
          most = std::max(most, std::abs(before[k].centre[1] - surface.pieces()[k].centre[1]));
        }
    }
    // Lines that end near a node of a skewed mesh may end on the next face: that moves the surface by nothing.
    EXPECT_LE(changes, std::string(c.name).find("skewed") == std::string::npos ? 0 : 10) << c.name;
    // Of a cell's height. The centroid of a cut cell moves by some 0.3 % and turns the line by several times that.
    EXPECT_LT(most / 0.125, 0.05) << c.name;
  }
}

}  // namespace
}  // namespace wetfront::mpm
