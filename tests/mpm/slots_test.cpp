// Points in slots: whatever moves, the order in the cells is that of a plain list, and dead slots hold nothing.
#include "mpm/grid/material_points.h"
#include "tests/mpm/sheared_sand.h"

#include <gtest/gtest.h>

#include <random>

namespace wetfront::mpm {
namespace {

/// The same moves on lists of point numbers, one list per soil and cell.
struct Lists {
  std::vector<std::vector<double>> points;
  void move(const std::vector<Mover>& movers, std::size_t cells) {
    for (std::size_t m = movers.size(); m-- > 0;) {
      const Mover& mover = movers[m];
      auto& from = points[static_cast<std::size_t>(mover.soil) * cells + mover.from];
      auto& to = points[static_cast<std::size_t>(mover.soil) * cells + mover.to];
      to.push_back(from[mover.index]);
      from[mover.index] = from.back();
      from.pop_back();
    }
  }
};

struct SlotsUnderMotion : ::testing::Test {
  static constexpr int across = 6;
  static constexpr std::size_t cells = across * across;
  meshes::Mesh mesh = [] {
    meshes::Mesh m = test::box(across, across, across, across);
    for (std::size_t c = cells / 2; c < cells; ++c) m.region[c] = 1;
    return m;
  }();
  Grid<2> grid{mesh};
  std::vector<std::size_t> counts = std::vector<std::size_t>(cells, 0);
  std::mt19937 random{7};

  MaterialPoints<2> numbered(Lists& lists) {
    std::vector<Vector<2>> positions;
    std::vector<double> numbers;
    lists.points.resize(2 * cells);
    for (std::size_t c = 0; c < cells; ++c) {
      counts[c] = c % 5;
      for (std::size_t k = 0; k < counts[c]; ++k) {
        positions.push_back({0.5 + static_cast<double>(c % across), 0.5 + static_cast<double>(c / across)});
        numbers.push_back(static_cast<double>(numbers.size() + 1));
        lists.points[(c < cells / 2 ? 0 : cells) + c].push_back(numbers.back());
      }
    }
    return {grid, positions, numbers, counts};  // the number of a point is its "volume"
  }
  std::vector<Mover> some_movers(const MaterialPoints<2>& points) {
    std::vector<Mover> movers;
    for (const Block& block : points.blocks())
      for (std::size_t k = 0; k < block.count; ++k)
        if (random() % 3 == 0) {
          const std::size_t to = random() % cells;
          if (to != block.cell) movers.push_back({block.cell, to, k, block.soil});
        }
    return movers;
  }
  static void expect_sound(const MaterialPoints<2>& points, const Lists& lists) {
    const Column& volume = *points.columns.find("volume");
    std::vector<double> expected;
    for (const auto& list : lists.points) expected.insert(expected.end(), list.begin(), list.end());
    ASSERT_EQ(points.in_order(volume), expected);
    std::size_t before = 0, live = 0;
    std::vector<char> taken(points.slots(), 0);
    for (const Block& block : points.blocks()) {
      const std::size_t key = static_cast<std::size_t>(block.soil) * cells + block.cell + 1;
      EXPECT_GT(key, before);  // by soil, then by cell
      before = key;
      EXPECT_EQ(block.first % SlotRooms::unit, 0u);
      live += block.count;
      for (std::size_t p = block.first; p < block.first + SlotRooms::rounded(block.count); ++p) {
        EXPECT_FALSE(taken[p]) << "two blocks share slot " << p;
        taken[p] = 1;
        if (p >= block.first + block.count) {
          EXPECT_EQ(volume[0][p], 0.0);
        }
      }
    }
    EXPECT_EQ(live, points.size());
  }
};

TEST_F(SlotsUnderMotion, KeepTheOrderOfPlainListsAndNothingInDeadSlots) {
  Lists lists;
  MaterialPoints<2> points = numbered(lists);
  points.make_room(grid);
  Column& scratch = points.columns.provide({"scratch", "", "-", 1, Lifetime::step}, "test");
  points.columns.allocate();
  expect_sound(points, lists);
  for (int round = 0; round < 300; ++round) {
    const auto movers = some_movers(points);
    points.move(grid, movers, scratch);
    lists.move(movers, cells);
    expect_sound(points, lists);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST_F(SlotsUnderMotion, AllPointsFitIntoOneCellAndOutAgain) {
  Lists lists;
  MaterialPoints<2> points = numbered(lists);
  points.make_room(grid);
  Column& scratch = points.columns.provide({"scratch", "", "-", 1, Lifetime::step}, "test");
  points.columns.allocate();
  for (const auto& target : {std::size_t{3}, std::size_t{20}}) {
    std::vector<Mover> movers;
    for (const Block& block : points.blocks())
      for (std::size_t k = 0; k < block.count; ++k)
        if (block.cell != target) movers.push_back({block.cell, target, k, block.soil});
    points.move(grid, movers, scratch);
    lists.move(movers, cells);
    expect_sound(points, lists);
  }
  EXPECT_EQ(points.blocks().size(), 2u);  // one per soil
}

}  // namespace
}  // namespace wetfront::mpm
