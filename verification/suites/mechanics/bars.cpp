#include "verification/exact/vibrating_bar.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double length = 25, young = 100, density = 1;  // benchmarks.md section 6
constexpr int samples = 80;                              // over two periods

exact::VibratingBarSolution solution(double velocity) {
  return exact::VibratingBarSolution({length, young, density, velocity});
}

/// Along the first axis, one cell thick, nu = 0: sides need no rollers, but the mode of a cell that breathes across is
/// not asked for.
template <int dim>
mpm::Problem<dim> bar(int cells, double velocity, const mpm::SkeletonScheme& scheme) {
  const double width = length / cells;
  const auto exact = solution(velocity);
  // room for the tip to move into: as long as it swings, in whole cells
  const int room = static_cast<int>(std::ceil(exact.displacement(length, exact.period() / 4) / width));
  auto problem = dry_problem<dim>(box_mesh(dim, {length + room * width, width, width}, {cells + room, 1, 1}),
                                  dry_soil(density, young, 0), evenly(2 * exact.period(), samples));
  fill_only<dim>(problem, [](const meshes::Point& at) { return at[0] < length; });
  problem.skeleton = scheme;
  if constexpr (dim == 2) add_rollers(problem, {"left", "base", "top"});
  if constexpr (dim == 3) add_rollers(problem, {"left", "base", "top", "front", "back"});
  problem.initial_velocity = [exact](const std::array<double, dim>& at) {
    std::array<double, dim> v{};
    v[0] = exact.velocity(at[0], 0);
    return v;
  };
  return problem;
}

/// Relative to the amplitude, rms over two periods.
template <int dim>
double error_of(const Motion<dim>& motion, const exact::VibratingBarSolution& exact) {
  double squares = 0;
  for (const auto& cloud : motion.clouds)
    squares += std::pow(cloud.mean_velocity(0) - exact.mean_velocity(cloud.time), 2);
  return std::sqrt(squares / static_cast<double>(motion.clouds.size())) / exact.mean_velocity(0);
}

/// Time of the second upward passing of zero by the mean velocity, over the exact one (7/4 periods), less 1.
template <int dim>
double phase_error(const Motion<dim>& motion, const exact::VibratingBarSolution& exact) {
  double passed = 0;
  for (std::size_t i = 1; i < motion.clouds.size(); ++i) {
    const double a = motion.clouds[i - 1].mean_velocity(0), b = motion.clouds[i].mean_velocity(0);
    if (a < 0 && b >= 0)
      passed = motion.clouds[i - 1].time + (motion.clouds[i].time - motion.clouds[i - 1].time) * a / (a - b);
  }
  return passed / (1.75 * exact.period()) - 1;
}

template <int dim>
reports::Series velocities(const Motion<dim>& motion, const std::string& label) {
  auto series = points(label);
  for (const auto& cloud : motion.clouds) put(series, cloud.time, cloud.mean_velocity(0));
  return series;
}

reports::Figure figure_of(const exact::VibratingBarSolution& exact, std::vector<reports::Series> runs) {
  auto figure = figure_frame({"mean_velocity", "Velocity of the centre of mass", "Time series"}, {"time", "s"},
                             {"velocity", "m/s"});
  auto curve = line("closed form");
  for (int i = 0; i <= 200; ++i) put(curve, i * exact.period() / 100, exact.mean_velocity(i * exact.period() / 100));
  figure.series = {curve};
  for (auto& run : runs) figure.series.push_back(std::move(run));
  return figure;
}

template <int dim>
void small_swing(MotionBook& book) {
  const auto exact = solution(0.1);
  const auto motion = book.move<dim>("40 cells", bar<dim>(40, 0.1, {}));
  book.page.judge("error", "rms error of the mean velocity over two periods, relative to its amplitude, 40 cells",
                  error_of(motion, exact),
                  {0.02, "1",
                   "first order in the cell size, 2.1 % with 20 cells and 1.0 % with 40: the tip draws the last cell's "
                   "forces with it"});
  book.page.judge("period", "period from the last passing of zero, relative", std::abs(phase_error(motion, exact)),
                  {0.005, "1", "as above; no point crosses a cell"});
  book.page.draw(figure_of(exact, {velocities(motion, fmt::format("{}-D, 40 cells", dim))}));
}

/// A tenfold velocity: the tip swings by 1.6 m, through more than three of 50 cells.
void crossing_swing(MotionBook& book) {
  const double velocity = 1;
  const auto exact = solution(velocity);
  std::vector<reports::Series> runs;
  using mpm::ShapeFunctions;
  for (const auto shape : {ShapeFunctions::linear, ShapeFunctions::quadratic_spline}) {
    mpm::SkeletonScheme scheme;
    scheme.shape = shape;
    const auto motion = book.move<2>(scheme_text(scheme), bar<2>(50, velocity, scheme));
    const double error = error_of(motion, exact);
    const std::string text = "rms error of the mean velocity over two periods, 50 cells, " + scheme_text(scheme);
    if (shape == ShapeFunctions::linear)
      book.page.show("error", text, error, "1");
    else
      book.page.judge("error", text, error,
                      {0.03, "1",
                       "strains reach 6 % (amplitude 1.6 of 25 m): the rate form is off by that share of "
                       "the strain energy, in and out of phase"});
    runs.push_back(velocities(motion, scheme_text(scheme)));
  }
  book.page.draw(figure_of(exact, std::move(runs)));
}

}  // namespace

std::vector<Case> bar_cases() {
  const std::string requirement = "A bar swings at its first mode's period and keeps its energy.";
  const std::string source = "benchmarks.md section 6 (L = 25, E = 100, rho = 1, v0 = 0.1).";
  return {
      motion_case({"bar_2d", "M1 Vibrating bar, plane strain", requirement, source, Effort::quick, {}}, small_swing<2>),
      motion_case({"bar_3d", "M1 Vibrating bar, three dimensions", requirement, source, Effort::quick, {}},
                  small_swing<3>),
      motion_case({"bar_crossing", "M1 Vibrating bar, points cross cells", requirement, source, Effort::quick, {}},
                  crossing_swing)};
}

}  // namespace wetfront::verification
