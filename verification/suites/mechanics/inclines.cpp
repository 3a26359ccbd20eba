#include "verification/exact/soil_strength.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double degree = std::numbers::pi / 180, slope = 30 * degree, gravity = 9.81, density = 2000;

/// A block of 1 m on a base that lies along the first
/// axis, with gravity turned, or on a base that is itself inclined (the mesh turned, gravity down).
struct Block {
  double friction;  ///< of the base
  bool turned_mesh;
  double end = 2;
};

template <int dim>
mpm::Problem<dim> block(const Block& b) {
  constexpr int up = dim - 1;
  const double h = 0.25;
  const double length = 17;
  auto mesh = dim == 2 ? rectangle_mesh(length, 1.5, 68, 6) : box_mesh(3, {length, 1, 1.5}, {68, 4, 6});
  std::vector<char> empty(mesh.cell_count());
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto at = mesh.cell_centre(c);
    empty[c] = at[0] > 2 * h && at[0] < 2 * h + 1 && at[static_cast<std::size_t>(up)] < 1 ? 0 : 1;
  }
  if (b.turned_mesh)  // downhill is to the right
    for (auto& node : mesh.nodes) {
      const double s = node[0], n = node[static_cast<std::size_t>(up)];
      node[0] = s * std::cos(slope) + n * std::sin(slope);
      node[static_cast<std::size_t>(up)] = -s * std::sin(slope) + n * std::cos(slope);
    }
  auto problem = dry_problem<dim>(std::move(mesh), dry_soil(density, 5e6, 0.2), evenly(b.end, 200));
  problem.empty_cells = std::move(empty);
  if (b.turned_mesh)
    problem.gravity[up] = -gravity;
  else
    problem.gravity[0] = gravity * std::sin(slope), problem.gravity[up] = -gravity * std::cos(slope);
  problem.initial_stress = mpm::InitialStress::k0;
  problem.skeleton_boundary.push_back(mpm::FrictionalContact{"base", b.friction, "suite"});
  if (dim == 3) add_rollers(problem, {"front", "back"});
  problem.skeleton.integration = mpm::StressIntegration::points;  // mixed: it rocks more, 1.6 % at mu = 0.5
  problem.skeleton.pic = 0.01;  // the block comes to rest on its base; PIC leaves what moves as a whole alone
  return problem;
}

/// Along the slope, from where it was at the first output.
template <int dim>
std::vector<std::array<double, 2>> slid(const Motion<dim>& motion, const Block& b) {
  std::vector<std::array<double, 2>> out;
  for (const auto& cloud : motion.clouds) {
    const double x = cloud.mean_velocity(0), y = cloud.mean_velocity(dim - 1);
    out.push_back({cloud.time, b.turned_mesh ? x * std::cos(slope) - y * std::sin(slope) : x});
  }
  return out;
}

/// Least squares through the velocities from `first` on: the block rocks about its mean.
double slope_of(const std::vector<std::array<double, 2>>& path, std::size_t first) {
  double n = 0, t = 0, v = 0, tt = 0, tv = 0;
  for (std::size_t k = first; k < path.size(); ++k) {
    const auto& [time, velocity] = path[k];
    n += 1, t += time, v += velocity, tt += time * time, tv += time * velocity;
  }
  return (n * tv - t * v) / (n * tt - t * t);
}

template <int dim>
void slide(bool turned_mesh, MotionBook& book) {
  auto figure =
      figure_frame({"velocity", "Velocity along the slope", "Time series"}, {"time", "s"}, {"velocity", "m/s"});
  int colour = 0;
  for (const double friction : {0.0, 0.2, std::tan(20 * degree), 0.5, 0.6}) {
    const Block b{friction, turned_mesh, friction > 0.3 ? 4.0 : 2.0};  // the slower, the longer it rocks about its mean
    const double expected = exact::sliding_acceleration(slope, friction, gravity);
    const auto motion = book.move<dim>(fmt::format("mu = {:.3g}", friction), block<dim>(b));
    const auto path = slid(motion, b);
    auto dots = points(fmt::format("mu = {:.3g}", friction), colour),
         exact = line(fmt::format("closed form, {:.3g}", friction), colour++);
    for (const auto& [t, v] : path) put(dots, t, v), put(exact, t, expected * t);
    figure.series.push_back(exact);
    figure.series.push_back(dots);
    const std::size_t settled = path.size() / 4;  // the block first finds its place on the base
    if (expected > 0) {
      book.page.expect("error", fmt::format("acceleration, mu = {:.3g} [m/s2]", friction), slope_of(path, settled),
                       expected, {0.01, "1", "the issue's"});
    } else {
      double mean = 0;
      for (std::size_t k = path.size() / 2; k < path.size(); ++k) mean += path[k][1] / (path.size() - path.size() / 2);
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
  auto problem = dry_problem<2>(rectangle_mesh(2, height, 1, cells),
                                frictional_soil(density, {10e6, 0.3, "suite"}, {friction, 0, dilatancy, {}, "suite"}),
                                evenly(end, 12));
  problem.gravity = {gravity * std::sin(angle), -gravity * std::cos(angle)};
  problem.fixities.push_back({"base", {true, true, false}, "suite"});
  problem.skeleton_boundary.push_back(mpm::PeriodicSkeleton{"left", "right", "suite"});
  problem.stages[0].local_damping = 0;
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
