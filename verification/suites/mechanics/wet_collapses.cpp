#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/mechanics/shape_of.h"
#include "verification/suites/mechanics/wet_setups.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double degree = std::numbers::pi / 180, gravity = 9.81, width = 0.2, height = 0.1;

/// Saturated sand, hydrostatic at the start, beside a smooth wall on a rough base; its right side is let go. The water
/// is a hundred times softer than water is, to let the steps be longer: at 1 kPa of pressure it gives way by 5e-5.
mpm::Problem<2> saturated_column(int cells, double end) {
  const double h = width / cells;
  const int along = 3 * cells, over = static_cast<int>(std::lround(height / h)) + 2;
  WetColumn sand;
  sand.conductivity = 1e-3, sand.water_modulus = 20e6, sand.young = 1e6;
  auto problem = wet_problem(sand, mpm::LiquidScheme::implicit_drag, evenly(end, 10));
  problem.mesh = rectangle_mesh(along * h, over * h, along, over);
  problem.soils[0].law = mpm::MohrCoulomb{30 * degree, 0, 0, 0, "suite"};
  problem.gravity[1] = -gravity;
  problem.skeleton_boundary.clear();
  problem.fixities = {{"left", {true, false, false}, "suite"}, {"base", {true, true, false}, "suite"}};
  problem.water_boundary.clear();  // nothing passes its surface
  problem.initial_stress = mpm::InitialStress::k0;
  problem.skeleton.pic = 0.005;
  fill_only<2>(problem, [](const meshes::Point& at) { return at[0] < width && at[1] < height; });
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes)
    problem.initial_pressure.push_back(1000 * gravity * std::max(0.0, height - node[1]));
  return problem;
}

double front_of(const Cloud<2>& cloud) {
  std::vector<double> x;
  for (const auto& at : cloud.position) x.push_back(at[0]);
  const auto there = x.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(x.size()));
  std::nth_element(x.begin(), there, x.end());
  return *there;
}

void fall(MotionBook& book) {
  const double end = 8 * std::sqrt(height / gravity);
  book.energy = {0.15, "1", "half a per cent of PIC in each step, as in dry collapses"};
  const auto motion = book.move<2>("20 x 10 cells", saturated_column(20, end));
  const auto &first = motion.history.ledger.front(), &last = motion.history.ledger.back();
  book.page.judge("water", "water stored less what it was, with what left, relative",
                  std::abs(last.stored + last.outflow - last.infiltrated - first.stored) / first.stored,
                  {1e-8, "1", "the points carry it; what leaves is booked"});
  const auto& cloud = motion.clouds.back();
  book.page.show("run_out", "run-out over width", front_of(cloud) / width - 1, "1");
  book.page.judge("rest", "kinetic energy at the end over the potential energy at the start",
                  cloud.kinetic_energy() / (0.5 * cloud.total_mass() * gravity * height),
                  {0.01, "1", "flow has ceased but for what still drains"});
  book.page.draw(shape_of(motion, {0, motion.clouds.size() / 3, motion.clouds.size() - 1}));
}

constexpr double kink = 2.5, thick = 0.6, slope_width = 7.5;

double ground(double x) {
  return x < kink ? 0 : (x - kink) * std::tan(30 * degree);
}

/// A rectangle of `columns` x `rows` cells, put on the ground: level up to the kink, 30 degrees beyond.
meshes::Mesh slope_mesh(int columns, int rows, double height) {
  meshes::Mesh mesh = rectangle_mesh(slope_width, height, columns, rows);
  for (auto& node : mesh.nodes) node[1] += ground(node[0]);
  return mesh;
}

/// The seed paper's sand (S_min 0.087, 3e-11 m2), its lower half saturated, under rain, on a base of 20 degrees that is
/// less than the slope.
mpm::Problem<2> wet_slope(int columns, double end) {
  const int over = columns * 4 / 30;
  WetColumn sand;
  sand.conductivity = 3e-11 * 9810 / 1e-3, sand.porosity = 0.46, sand.grain_density = 2690;
  auto problem = wet_problem(sand, mpm::LiquidScheme::implicit_drag, evenly(end, 12));
  problem.mesh = slope_mesh(columns, over * 9 / 4, thick * 9 / 4);
  problem.soils[0].law = mpm::MohrCoulomb{34 * degree, 0, 0, {}, "suite"};
  problem.gravity[1] = -gravity;
  problem.fixities = {{"left", {true, false, false}, "suite"}, {"right", {true, false, false}, "suite"}};
  problem.skeleton_boundary = {mpm::FrictionalContact{"base", std::tan(20 * degree), "suite"}};
  problem.water_boundary = {mpm::RainSide{mpm::free_surface, {{0}, {3e-5}}, "suite"}};
  problem.initial_stress = mpm::InitialStress::k0;
  problem.skeleton.pic = 0.001;
  fill_only<2>(problem, [](const meshes::Point& at) { return at[0] > 3 && at[1] - ground(at[0]) < thick; });
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes)
    problem.initial_pressure.push_back(std::max(-4e3, 1000 * gravity * (thick / 2 - (node[1] - ground(node[0])))));
  return problem;
}

void slide(MotionBook& book) {
  book.energy = {0.03, "1", "a tenth of a per cent of PIC in each step: .013 measured"};
  const auto motion = book.move<2>("18 x 4 cells in a mesh of 30 x 9", wet_slope(30, 3));
  const auto &first = motion.history.ledger.front(), &last = motion.history.ledger.back();
  book.page.judge("water", "water stored less what it was, with what rained in and seeped out, relative",
                  std::abs(last.stored + last.outflow - last.infiltrated - first.stored) / first.stored,
                  {1e-11, "1", "points carry it, what leaves is booked: round-off of 2e4 steps"});
  book.page.judge("water", "rain that neither entered nor ran off, relative",
                  std::abs(last.infiltrated + last.run_off - last.rain_asked) / last.rain_asked,
                  {1e-11, "1", "round-off"});
  double most = 0;
  for (const auto& snapshot : motion.history.snapshots)
    for (const double p : snapshot.cell_pressure)
      if (std::isfinite(p)) most = std::max(most, std::abs(p));
  book.page.judge("pressure", "largest pore pressure of a cell at the outputs [kPa]", most / 1e3,
                  {230, "kPa", "a tenth of rho c v, the undrained stop at 2.5 m/s"});
  const auto& cloud = motion.clouds.back();
  const double moved = motion.clouds.front().mean([&](std::size_t q) { return motion.clouds.front().position[q][0]; }) -
                       cloud.mean([&](std::size_t q) { return cloud.position[q][0]; });
  book.page.show("run_out", "way of the centre of mass along the level [m]", moved, "m");
  book.page.judge("rest", "kinetic energy at the end over the largest",
                  [&] {
                    double largest = 0;
                    for (const auto& row : motion.history.motion) largest = std::max(largest, row.kinetic);
                    return motion.history.motion.back().kinetic / largest;
                  }(),
                  {0.01, "1", "it has come to rest in front of the wall"});
  book.page.draw(shape_of(motion, {0, motion.clouds.size() / 3, motion.clouds.size() - 1}));
}

}  // namespace

std::vector<Case> wet_collapse_cases() {
  return {motion_case({"slide_wet",
                       "M3 A rained slope slides over a kink",
                       "Partly saturated sand slides through many cells, keeps its water and comes to rest.",
                       "Two velocities (Lee et al. 2021, corrected), Mohr-Coulomb 34 degrees, base 20 degrees; "
                       "design/flume.md C.",
                       Effort::everyday,
                       {}},
                      slide),
          motion_case({"collapse_saturated",
                       "M3 Saturated column collapse",
                       "A saturated column falls, keeps its water and comes to rest.",
                       "Two velocities (Lee et al. 2021, corrected), Mohr-Coulomb 30 degrees.",
                       Effort::heavy,
                       {}},
                      fall)};
}

}  // namespace wetfront::verification
