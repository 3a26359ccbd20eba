#include "verification/exact/soil_strength.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/incline_block.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double degree = std::numbers::pi / 180, slope = InclineBlock::slope, gravity = InclineBlock::gravity;

template <int dim>
void slide(bool turned_mesh, MotionBook& book) {
  auto figure =
      figure_frame({"velocity", "Velocity along the slope", "Time series"}, {"time", "s"}, {"velocity", "m/s"});
  int colour = 0;
  book.energy = weighty_energy;
  for (const double friction : {0.0, 0.2, std::tan(20 * degree), 0.5, 0.6}) {
    // The slower, the longer it rocks about its mean.
    const InclineBlock b{.friction = friction, .turned_mesh = turned_mesh, .end = friction > 0.3 ? 4.0 : 2.0};
    const double expected = exact::sliding_acceleration(slope, friction, gravity);
    const auto motion = book.move<dim>(fmt::format("mu = {:.3g}", friction), block_problem<dim>(b));
    const auto path = block_path(motion, b);
    auto dots = points(fmt::format("mu = {:.3g}", friction), colour),
         exact = line(fmt::format("closed form, {:.3g}", friction), colour++);
    for (const BlockState& s : path) put(dots, s.time, s.velocity[0]), put(exact, s.time, expected * s.time);
    figure.series.push_back(exact);
    figure.series.push_back(dots);
    const std::size_t settled = path.size() / 4;  // the block first finds its place on the base
    if (expected > 0) {
      book.page.expect("error", fmt::format("acceleration, mu = {:.3g} [m/s2]", friction),
                       mean_acceleration(path, settled), expected, {0.01, "1", "the issue's"});
    } else {
      double mean = 0;
      for (std::size_t k = path.size() / 2; k < path.size(); ++k)
        mean += path[k].velocity[0] / static_cast<double>(path.size() - path.size() / 2);
      book.page.judge("stick", fmt::format("mean velocity of a block that sticks, second half, mu = {:.3g}", friction),
                      std::abs(mean),
                      {0.01, "m/s", "free fall along the slope would give 7.4 m/s; an elastic block rocks"});
    }
  }
  book.page.draw(figure);
}

/// A layer whose sides are periodic: what is uphill follows what is downhill.
double layer_acceleration(double friction, double dilatancy, double angle, MotionBook& book) {
  const int cells = 10;
  const double height = 1, end = 0.8;  // points may not reach the next cell: sides are tied, points are not handed over
  auto problem = dry_problem<2>(
      rectangle_mesh(2, height, 1, cells),
      frictional_soil(InclineBlock::density, {10e6, 0.3, "suite"}, {friction, 0, dilatancy, {}, "suite"}),
      evenly(end, 12));
  problem.gravity = {gravity * std::sin(angle), -gravity * std::cos(angle)};
  problem.fixities.push_back({"base", {true, true, false}, "suite"});
  problem.skeleton_boundary.push_back(mpm::PeriodicSkeleton{"left", "right", "suite"});
  problem.stages[0].local_damping = 0;
  book.energy = weighty_energy;
  const auto motion =
      book.move<2>(fmt::format("{:.4g} degrees, psi {:.3g}", angle / degree, dilatancy / degree), problem);
  const auto top_velocity = [&](const Cloud<2>& cloud) {
    double v = 0, n = 0;
    for (std::size_t p = 0; p < cloud.size(); ++p)
      if (cloud.position[p][1] > 0.8 * height) v += cloud.velocity[p][0], ++n;
    return v / n;
  };
  return (top_velocity(motion.clouds.back()) - top_velocity(motion.clouds[5])) /
         (motion.clouds.back().time - motion.clouds[5].time);
}

/// Davis' criterion: without dilatancy a slope fails at sin phi, not at tan phi.
void infinite_slope(MotionBook& book) {
  const double phi = 34 * degree;
  for (const double angle : {27.0, 32.0}) {
    const double measured = layer_acceleration(phi, 0, angle * degree, book);
    const double safety = exact::safety_of({angle * degree, phi, 0});
    const double expected =
        gravity * (std::sin(angle * degree) - std::cos(angle * degree) * exact::davis_friction(phi, 0));
    if (safety > 1)
      book.page.judge("stands", fmt::format("acceleration of the surface, {:g} degrees, safety {:.3f}", angle, safety),
                      std::abs(measured),
                      {0.1, "m/s2", "it rests but for an elastic swing; beyond failure 0.3 and more"});
    else
      book.page.expect(
          "fails", fmt::format("acceleration of the surface [m/s2], {:g} degrees, safety {:.3f}", angle, safety),
          measured, expected,
          {0.1, "1", "the lowest row shears alone; its strength is that of its points' mean, half a cell up"});
  }
  book.page.show("tan_phi", "safety at 32 degrees were it tan phi/tan beta", exact::safety_of({32 * degree, phi, phi}),
                 "1");
}

}  // namespace

std::vector<Case> incline_cases() {
  const std::string requirement = "A block slides with g (sin b - mu cos b), or sticks.";
  const std::string source = "benchmarks.md section 6.";
  return {
      motion_case({"incline", "M2 Block on an incline, gravity turned", requirement, source, Effort::everyday, {}},
                  [](MotionBook& book) { slide<2>(false, book); }),
      motion_case({"incline_turned", "M2 Block on an inclined base", requirement, source, Effort::everyday, {}},
                  [](MotionBook& book) { slide<2>(true, book); }),
      motion_case({"incline_3d", "M2 Block on an incline, three dimensions", requirement, source, Effort::everyday, {}},
                  [](MotionBook& book) { slide<3>(false, book); }),
      motion_case({"infinite_slope",
                   "M2 Infinite slope without dilatancy",
                   "It fails where tan b passes sin phi.",
                   "Davis 1968; physics.md section 1.5.",
                   Effort::quick,
                   {}},
                  infinite_slope)};
}

}  // namespace wetfront::verification
