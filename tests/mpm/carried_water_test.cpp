// Water and pressure that travel with points through the grid: nothing is lost, nothing is smeared, nothing overshoots.
#include "mpm/coupling/carried_water.h"
#include "mpm/grid/migration.h"
#include "mpm/skeleton/rigid_skeleton.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wetfront::mpm {
namespace {

constexpr double h = 0.1;
constexpr int cells_x = 40, cells_y = 16;

/// What CarriedWater needs of the rest: columns of a skeleton and of seepage.
class Carrier : public Effect<2> {
 public:
  Carrier() : Effect<2>("carrier", "test", "none") {}
  void join(StagePlan<2>& plan) override {
    plan.provide_on_points({"mass", "m", "kg"});
    plan.provide_on_points({"velocity", "v", "m/s", 2});
    plan.provide_on_points(shape_value_spec<2>());
    plan.provide_on_points(shape_gradient_spec<2>());
    plan.provide_on_nodes({"displacement", "u", "m", 2});
    c.pressure = &plan.provide_on_nodes({"pressure", "p", "Pa"});
    c.pressure_before = &plan.provide_on_nodes({"pressure before", "p", "Pa"});
    c.pressure_earlier = &plan.provide_on_nodes({"pressure earlier", "p", "Pa"});
    c.stored = &plan.provide_on_nodes({"stored", "W", "m2"});
    c.stored_before = &plan.provide_on_nodes({"stored before", "W", "m2"});
    c.point_pressure = &plan.provide_on_points({"pressure", "p", "Pa"});
    c.point_saturation = &plan.provide_on_points({"saturation", "S", "-"});
    trial = &plan.provide_on_nodes({"trial", "p", "Pa"});
    for (const Soil& soil : plan.problem.soils)
      contents.emplace_back(soil, tabulated_soil_water(soil, *plan.problem.water).curve, 0.2e9);
    carried = std::make_unique<CarriedWater<2>>(plan, c, *trial, contents);
    migration = std::make_unique<Migration<2>>(plan);
    migration->prepare(1);
  }
  SeepageColumns c{};
  Column* trial = nullptr;
  std::vector<SoilContent> contents;
  std::unique_ptr<CarriedWater<2>> carried;
  std::unique_ptr<Migration<2>> migration;
};

/// A block of 10 x 10 cells in the lower left of a large empty mesh.
Problem<2> block(int points_per_cell) {
  Problem<2> problem = test::seed_column(4, 0.087, 0, 1);
  problem.mesh = test::box(cells_x * h, cells_y * h, cells_x, cells_y);
  problem.soils[0].elastic = Elastic{10e6, 0.3, "o"};  // points have room to move
  problem.points_per_cell = points_per_cell;
  problem.empty_cells.assign(static_cast<std::size_t>(cells_x * cells_y), 1);
  for (int j = 1; j <= 10; ++j)
    for (int i = 2; i < 12; ++i) problem.empty_cells[static_cast<std::size_t>(j * cells_x + i)] = 0;
  problem.initial_pressure.assign(problem.mesh.node_count(), 0);
  return problem;
}

struct Worst {
  double error = 0, beyond = 0, water = 0, nodal_water = 0;  ///< relative to the range, and to the water
  int crossings = 0;
};

/// Moves the block by `travel` in x, with a shear that turns its left side by `shear` (tangent), and compares.
template <class Pressure>
Worst move(int points_per_cell, double travel, double shear, Pressure pressure) {
  const Problem<2> problem = block(points_per_cell);
  Fields<2> fields(problem);
  StagePlan<2> plan(problem, 0, fields);
  auto owned = std::make_unique<Carrier>();
  Carrier& carrier = *owned;
  plan.join(std::move(owned));
  plan.enter();
  auto& points = fields.points;
  Column &position = points.columns.at("position"), &mass = points.columns.at("mass"),
         &volume = points.columns.at("volume"), &shape = points.columns.at("shape value");
  const auto stencils = [&] {
    for (const Block& b : points.blocks())
      fill_stencils<2>(fields.grid, points, b, shape, points.columns.at("shape gradient"));
  };
  for (const Block& b : points.blocks())
    for (std::size_t q = b.first; q < b.first + b.count; ++q) mass[0][q] = volume[0][q] * 0.54 * 2690;
  stencils();
  const std::size_t nodes = fields.grid.node_count();
  double low = 1e300, high = -1e300;
  for (std::size_t i = 0; i < nodes; ++i)
    (*carrier.c.pressure)[0][i] = (*carrier.trial)[0][i] =
        pressure(fields.grid.node(static_cast<int>(i))[0], fields.grid.node(static_cast<int>(i))[1]);
  for (const Block& b : points.blocks())
    for (int i = 0; i < 4; ++i) {
      low = std::min(low, (*carrier.c.pressure)[0][b.nodes[i]]);
      high = std::max(high, (*carrier.c.pressure)[0][b.nodes[i]]);
    }
  carrier.carried->begin();
  const double before = carrier.carried->total();
  constexpr int steps = 237;  // 0.09 of a cell each, so that no place in a cell repeats
  Worst worst;
  for (int step = 0; step < steps; ++step) {
    carrier.carried->before_motion();
    const auto velocity = [&](double y) { return (travel + shear * (y - 0.6)) / steps; };
    for (const Block& b : points.blocks())
      for (std::size_t q = b.first; q < b.first + b.count; ++q) {
        position[0][q] += velocity(position[1][q]);
        if (fields.grid.find_cell(points.position(q), static_cast<int>(b.cell)) != static_cast<int>(b.cell))
          carrier.migration->leaving(0).push_back({b.cell, b.cell, q - b.first, b.soil});
      }
    for (std::size_t i = 0; i < nodes; ++i)
      fields.grid.columns.at("displacement")[0][i] += velocity(fields.grid.node(static_cast<int>(i))[1]);
    const auto counts = points.count_of_cell();
    carrier.migration->run();
    worst.crossings += counts != points.count_of_cell();
    stencils();
    carrier.carried->after_motion();
    std::copy_n((*carrier.c.pressure)[0], nodes, (*carrier.trial)[0]);
  }
  // Where a point came from tells its exact pressure.
  double nodal = 0;
  for (const Block& b : points.blocks())
    for (std::size_t q = b.first; q < b.first + b.count; ++q) {
      double p = 0;
      for (int i = 0; i < 4; ++i) {
        const double here = (*carrier.c.pressure)[0][b.nodes[i]];
        p += shape[i][q] * here;
        nodal += shape[i][q] * carrier.carried->pores(q, problem.soils[0]) * carrier.contents[0].at(here).value;
      }
      const double x = position[0][q] - travel - shear * (position[1][q] - 0.6);
      worst.error = std::max(worst.error, std::abs(p - pressure(x, position[1][q])) / (high - low));
      worst.beyond = std::max({worst.beyond, (low - p) / (high - low), (p - high) / (high - low)});
    }
  worst.water = std::abs(carrier.carried->total() - before) / before;
  worst.nodal_water = std::abs(nodal - before) / before;
  return worst;
}

/// Hydrostatic around a water table in the middle of the block: unsaturated above.
double hydrostatic(double, double y) {
  return 9810 * (0.6 - y);
}
/// A smooth field of 10 cells' length that is curved everywhere, saturated in one half.
double wavy(double x, double y) {
  return 5000 * std::cos(std::numbers::pi * (x - 0.2)) + 2000 * (y - 0.6);
}

class CarriedWaterOf : public testing::TestWithParam<int> {};

/// `error`: of the pressure, relative to its range.
void expect_kept(const Worst& worst, double error) {
  EXPECT_LE(worst.water, 1e-10);
  EXPECT_LE(worst.error, error);
  EXPECT_LE(worst.beyond, 1e-2);
  EXPECT_LE(worst.nodal_water, 5e-3);
}

// The issue: >= 20 cells with 1 to 9 points per cell, water to 1e-10, p within 0.5 % of its range, no new extrema
// above 1 %.
TEST_P(CarriedWaterOf, ATranslatedBlockKeepsWaterAndPressure) {
  const Worst worst = move(GetParam(), 21.3 * h, 0, hydrostatic);
  EXPECT_GT(worst.crossings, 20);
  expect_kept(worst, 5e-3);
}

TEST_P(CarriedWaterOf, ASlantedBlockToo) {
  const Worst worst = move(GetParam(), 20.6 * h, 0.8, hydrostatic);
  expect_kept(worst, 5e-3);
}

// Curved over a wavelength of 20 cells, linear elements alone leave 0.4 % of the range; carrying it adds as much.
TEST_P(CarriedWaterOf, ASmoothFieldIsNotSmeared) {
  const Worst worst = move(GetParam(), 21.3 * h, 0.5, wavy);
  expect_kept(worst, 1.2e-2);
}

INSTANTIATE_TEST_SUITE_P(PointsPerCell, CarriedWaterOf, testing::Values(1, 4, 9));

}  // namespace
}  // namespace wetfront::mpm
