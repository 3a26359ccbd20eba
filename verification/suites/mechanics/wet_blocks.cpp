#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/mechanics/wet_setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::verification {
namespace {

using mpm::LiquidScheme;

constexpr double h = 0.05, suction = 3e3;
constexpr int across = 8;  ///< cells of the block, either way

/// Unsaturated sand of 8 x 8 cells, free all around, without weight, in a long empty mesh. Nothing passes its surface.
mpm::Problem<2> free_block(LiquidScheme scheme, double young, int points_per_cell, double end) {
  WetColumn sand;
  sand.young = young;
  mpm::Problem<2> problem = wet_problem(sand, scheme, evenly(end, 4));
  problem.mesh = rectangle_mesh(40 * h, 14 * h, 40, 14);
  problem.skeleton_boundary.clear();
  problem.fixities.clear();
  problem.water_boundary.clear();
  problem.points_per_cell = points_per_cell;
  problem.stages[0].motion = mpm::SkeletonMotion::dynamic;
  problem.soils[0].intrinsic_permeability = intrinsic(1e-9);
  fill_only<2>(problem, [&](const meshes::Point& at) {
    return at[0] > 2 * h && at[0] < (2 + across) * h && at[1] > 3 * h && at[1] < (3 + across) * h;
  });
  return problem;
}

/// One suction everywhere, which a stress that is the same in every direction bears: nothing pulls anywhere, so that
/// the motion given at the start goes on for ever. Points remember where they began.
mpm::Problem<2> balanced_block(LiquidScheme scheme, double young, int points_per_cell, double end) {
  auto problem = free_block(scheme, young, points_per_cell, end);
  problem.initial_pressure.assign(problem.mesh.node_count(), -suction);
  problem.gravity = {0, -1e-12};  // says where up is, for the stress at rest; pulls at nothing
  problem.initial_stress = mpm::InitialStress::k0;
  problem.soils[0].earth_pressure_at_rest = 1;
  problem.body_acceleration = [](const std::array<double, 2>&, double) { return std::array{0.0, 0.0}; };
  problem.output_times.insert(problem.output_times.begin(), 0);
  return problem;
}

/// Largest changes of what a point has, over its value at the start.
struct Changes {
  double water = 0, total = 0, content = 0, place = 0;  ///< place: from where it should be, over a cell
};

std::vector<std::size_t> by_origin(const Cloud<2>& cloud) {
  std::vector<std::size_t> order(cloud.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t p) { return cloud.origin[p]; });
  return order;
}

/// `velocity` at the place where a point began is the velocity that it keeps.
Changes changes(const Motion<2>& motion, double porosity,
                const std::function<std::array<double, 2>(const std::array<double, 2>&)>& velocity) {
  const auto &first = motion.clouds.front(), &last = motion.clouds.back();
  const auto before = by_origin(first), after = by_origin(last);
  Changes out;
  double water = 0, gained = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const std::size_t p = before[k], q = after[k];
    const double grains = (1 - porosity) * first.volume[p];
    const double was = first.water[p] / (first.volume[p] - grains), is = last.water[q] / (last.volume[q] - grains);
    out.water = std::max(out.water, std::abs(last.water[q] / first.water[p] - 1));
    out.content = std::max(out.content, std::abs(is / was - 1));
    water += first.water[p], gained += last.water[q] - first.water[p];
    const auto v = velocity(last.origin[q]);
    double off = 0;
    for (std::size_t a = 0; a < 2; ++a)
      off += std::pow(last.position[q][a] - last.origin[q][a] - v[a] * (last.time - first.time), 2);
    out.place = std::max(out.place, std::sqrt(off) / h);
  }
  out.total = std::abs(gained) / water;
  return out;
}

std::string name_of(LiquidScheme scheme) {
  return scheme == LiquidScheme::seepage ? "seepage" : "two velocities";
}

/// Through 24 cells as a whole: nothing has a reason to change.
void translate(LiquidScheme scheme, int points_per_cell, MotionBook& book) {
  const double speed = 1;
  auto problem = balanced_block(scheme, 10e6, points_per_cell, 24 * h / speed);
  const auto velocity = [speed](const std::array<double, 2>&) { return std::array{speed, 0.0}; };
  problem.initial_velocity = velocity;
  const std::string label = fmt::format("translated, {}, {} points per cell", name_of(scheme), points_per_cell);
  const Changes found = changes(book.move<2>(label, problem), problem.soils[0].porosity, velocity);
  const Gate round_off{1e-9, "1", "round-off of some thousand steps of stiff soil; measured 1e-12 and less"};
  book.page.judge("water", "water of a point, " + label, found.water, round_off);
  book.page.judge("error", "saturation of a point (water over pores), " + label, found.content, round_off);
  book.page.judge("water", "water of all points, " + label, found.total, {1e-12, "1", "round-off"});
}

/// Sheared by .6 at constant volume while it flies through 12 cells. Its free sides bear no shear stress, so this is
/// what it does only as far as its skeleton is soft (10 Pa: 2 Pa of shear against 3 kPa of suction). APIC, whose nodes
/// know a motion that is linear in space from the points exactly, also at the edges of a body; FLIP smooths it there,
/// which changes volumes.
void shear(LiquidScheme scheme, int points_per_cell, mpm::Transfer transfer, MotionBook& book) {
  const double rate = 20, speed = 20;
  auto problem = balanced_block(scheme, 10, points_per_cell, 0.6 / rate);
  const auto velocity = [=](const std::array<double, 2>& x) { return std::array{speed + rate * (x[1] - 7 * h), 0.0}; };
  problem.initial_velocity = velocity;
  problem.skeleton.transfer = transfer;
  const bool apic = transfer == mpm::Transfer::apic;
  if (apic) book.energy = {1e-5, "1", "APIC sees a linear motion exactly, its elastic answer not: 1.6e-7 measured"};
  if (!apic) book.energy = MotionBook::round_off_energy;
  const std::string label =
      fmt::format("sheared, {}, {} points per cell{}", name_of(scheme), points_per_cell, apic ? "" : ", FLIP");
  const Changes found = changes(book.move<2>(label, problem), problem.soils[0].porosity, velocity);
  book.page.judge("water", "water of all points, " + label, found.total, {1e-12, "1", "round-off"});
  if (!apic) {
    book.page.show("error", "saturation of a point (water over pores), " + label, found.content, "1");
    return;
  }
  book.page.judge("error", "place of a point, over a cell, " + label, found.place,
                  {1e-3, "1", "the elastic answer of the free sides: measured 1.5e-4, in proportion to E"});
  book.page.judge("error", "saturation of a point (water over pores), " + label, found.content,
                  {1e-3, "1", "the same: measured 1e-4 to 2e-4, in proportion to E"});
  book.page.judge("water", "water of a point, " + label, found.water,
                  {1e-5, "1", "what the suction's change drives through 1e-9 m/s"});
}

/// Wetter on one side, saturation far from uniform: water may redistribute, but none comes or goes.
void graded(int points_per_cell, MotionBook& book) {
  const double speed = 1;
  auto problem = free_block(LiquidScheme::implicit_drag, 10e6, points_per_cell, 24 * h / speed);
  problem.initial_velocity = [speed](const std::array<double, 2>&) { return std::array{speed, 0.0}; };
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes)
    problem.initial_pressure.push_back(-3e3 - 4e3 * (node[0] - 2 * h) / (across * h));
  const auto motion = book.move<2>(fmt::format("graded, {} points per cell", points_per_cell), problem);
  const auto& ledger = motion.history.ledger;
  double worst = 0;
  for (const auto& row : ledger) worst = std::max(worst, std::abs(row.stored / ledger.front().stored - 1));
  book.page.judge("water",
                  fmt::format("water gained or lost through 24 cells, graded, {} points per cell", points_per_cell),
                  worst, {1e-10, "1", "the points carry it"});
}

}  // namespace

std::vector<Case> wet_block_cases() {
  const std::string requirement =
      "Moving points keep their water, and their saturation while nothing changes their pores.";
  const std::string source = "physics.md section 1.8.";
  return {
      motion_case({"flying_block", "H1 A wetted block moves through cells", requirement, source, Effort::everyday, {}},
                  [](MotionBook& book) {
                    for (const int points : {1, 4, 9}) graded(points, book);
                  }),
      motion_case({"wet_block_translated", "H1 A wetted block, translated", requirement, source, Effort::everyday, {}},
                  [](MotionBook& book) {
                    for (const LiquidScheme scheme : {LiquidScheme::seepage, LiquidScheme::implicit_drag})
                      for (const int points : {1, 4, 9}) translate(scheme, points, book);
                  }),
      motion_case({"wet_block_sheared",
                   "H1 A wetted block, sheared at constant volume",
                   requirement,
                   source,
                   Effort::quick,
                   {}},
                  [](MotionBook& book) {
                    for (const LiquidScheme scheme : {LiquidScheme::seepage, LiquidScheme::implicit_drag}) {
                      for (const int points : {4, 9}) shear(scheme, points, mpm::Transfer::apic, book);
                      shear(scheme, 4, mpm::Transfer::flip, book);
                    }
                  })};
}

}  // namespace wetfront::verification
