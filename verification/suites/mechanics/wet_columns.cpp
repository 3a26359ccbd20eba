#include "verification/exact/de_boer.h"
#include "verification/exact/terzaghi.h"
#include "verification/exact/undrained.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/mechanics/wet_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

using mpm::LiquidScheme;

/// Pressure of the lowest cell and rms over the cells, of the exact initial pressure; settlement of the top.
struct Consolidation {
  double base, rms, settlement;
};

double settled(const meshes::Snapshot& snapshot) {
  return -snapshot.node_displacement.back()[1];  // the last node is on the top
}

exact::Terzaghi terzaghi_of(const WetColumn& c) {
  return {c.height, c.conductivity, 9810, c.oedometer_modulus(), c.load, c.porosity, c.water_modulus};
}

void consolidate(LiquidScheme scheme, const std::vector<double>& factors, MotionBook& book) {
  const WetColumn column;
  const exact::TerzaghiSolution exact(terzaghi_of(column));
  std::vector<double> times;
  for (const double factor : factors)
    times.push_back(factor * column.height * column.height / exact.consolidation_coefficient());
  auto problem = wet_problem(column, scheme, times);
  double ramp = 0;
  if (scheme == LiquidScheme::implicit_drag) {
    // Put on over ten periods of the undrained column, so that its waves do not ring on; half of it later in effect.
    const double density = (1 - column.porosity) * column.grain_density + column.porosity * 1000;
    ramp = 40 * column.height /
           exact::undrained_wave_speed({column.oedometer_modulus(), column.water_modulus, column.porosity}, density);
    std::get<mpm::Traction>(problem.skeleton_boundary.front()).factor = {{0, ramp}, {0, 1}};
  }
  const auto motion = book.move<2>("40 cells", problem);
  auto figure = figure_frame({"isochrones", "Excess pore pressure over height", "Profiles"}, {"pore pressure", "kPa"},
                             {"height", "m"});
  const Gate gate{0.01, "1", "the issue's, at h = H/40"};
  for (std::size_t t = 0; t < times.size(); ++t) {
    const auto& snapshot = motion.history.snapshots[t];
    auto curve = line(fmt::format("Terzaghi, T = {:g}", factors[t]), static_cast<int>(t));
    auto dots = points(fmt::format("T = {:g}", factors[t]), static_cast<int>(t));
    double squares = 0;
    for (int c = 0; c < column.cells; ++c) {
      const double y = column.height * (c + 0.5) / column.cells,
                   p = exact.pressure(column.height - y, times[t] - ramp / 2);
      const double ours = snapshot.cell_pressure[static_cast<std::size_t>(c)];
      squares += std::pow(ours - p, 2) / column.cells;
      put(curve, p / 1e3, y);
      put(dots, ours / 1e3, y);
    }
    figure.series.push_back(curve);
    figure.series.push_back(dots);
    const std::string at = fmt::format(", T = {:g}", factors[t]);
    book.page.judge("error", "rms error of the pressure over the cells, relative to that of the start" + at,
                    std::sqrt(squares) / exact.initial_pressure(), gate);
    book.page.expect("settlement", "settlement [m]" + at, settled(snapshot), exact.settlement(times[t] - ramp / 2),
                     gate);
  }
  book.page.draw(figure);
}

/// Skeleton and water with inertia, water nearly incompressible.
void de_boer(LiquidScheme scheme, const std::string& called, MotionBook& book) {
  WetColumn column;
  column.height = 5, column.porosity = 0.33, column.grain_density = 2000;
  const double lame = 5.5833e6, shear = 8.375e6;
  column.young = shear * (3 * lame + 2 * shear) / (lame + shear);
  column.poisson = lame / (2 * (lame + shear));
  column.conductivity = 1e-2, column.water_modulus = 20e9, column.load = 3e3, column.cells = 100;
  const exact::DeBoerSolution exact({lame, shear, 0.67, 2000, 1000, 1e-2, 9810, [](double) { return 3e3; }});
  const auto motion = book.move<2>("100 cells", wet_problem(column, scheme, evenly(0.05, 25)));
  auto figure = figure_frame({"settlement", "Displacement of the skeleton", "Time series"}, {"time", "s"},
                             {"displacement", "mm"});
  auto top = line("de Boer et al., z = 0", 0), low = line("de Boer et al., z = 1 m", 1);
  auto our_top = points(called + ", z = 0", 0), our_low = points(called + ", z = 1 m", 1);
  const std::size_t row = 2 * 80;  // nodes of the level 4 m over the base
  double worst = 0, worst_low = 0;
  for (const auto& snapshot : motion.history.snapshots) {
    const double u = exact.displacement(0, snapshot.time), v = exact.displacement(1, snapshot.time);
    const double ours = settled(snapshot), below = -snapshot.node_displacement[row][1];
    put(top, snapshot.time, 1e3 * u), put(low, snapshot.time, 1e3 * v);
    put(our_top, snapshot.time, 1e3 * ours), put(our_low, snapshot.time, 1e3 * below);
    worst = std::max(worst, std::abs(ours - u)), worst_low = std::max(worst_low, std::abs(below - v));
  }
  const double last = exact.displacement(0, 0.05);
  const Gate gate{0.02, "1",
                  "water of 20 GPa, not incompressible, leaves 0.3 % (the column compressed undrained); 5 cm cells "
                  "smear the arrival over 1 ms"};
  book.page.judge("error", "largest error of the surface's displacement over 0.05 s, relative to its last",
                  worst / last, gate);
  book.page.judge("error", "the same 1 m below", worst_low / last, gate);
  figure.series = {top, low, our_top, our_low};
  book.page.draw(figure);
}

/// Water of 2.15 GPa, 1e-9 m/s, a load put on at once: whatever the time, what is far from the drain bears the
/// undrained pressure, and near it no pressure lies above that.
void undrained_load(MotionBook& book) {
  WetColumn column;
  column.conductivity = 1e-9, column.water_modulus = 2.15e9, column.cells = 20;
  const double expected =
      exact::undrained_pressure({column.oedometer_modulus(), column.water_modulus, column.porosity}, column.load);
  for (const bool drained : {true, false})
    for (const double end : {1e-3, 1.0, 1e3}) {
      column.drained = drained;
      const std::string label = fmt::format("{}, {:g} s", drained ? "drained top" : "closed box", end);
      const auto motion = book.move<2>(label, wet_problem(column, LiquidScheme::seepage, {end}));
      const auto& p = motion.history.snapshots.back().cell_pressure;
      book.page.expect("error", "pressure of the lowest cell [Pa], " + label, p.front(), expected,
                       {0.001, "1", "no water can leave that far from the drain"});
      book.page.judge("overshoot", "pressure above the undrained one, relative, " + label,
                      std::max(0.0, *std::ranges::max_element(p) / expected - 1),
                      {0.01, "1", "equal-order pairs swing by 100 % at the drain; the stabilised split shall not"});
    }
}

}  // namespace

std::vector<Case> wet_column_cases() {
  const std::string requirement = "A loaded saturated column consolidates as Terzaghi has it.";
  const std::string source = "Terzaghi 1923, Verruijt 2013; benchmarks.md section 3.1.";
  return {
      motion_case(
          {"terzaghi_seepage", "H1 Terzaghi, seepage in a skeleton at rest", requirement, source, Effort::quick, {}},
          [](MotionBook& book) {
            consolidate(LiquidScheme::seepage, {0.05, 0.2, 0.5, 1}, book);
          }),
      motion_case({"terzaghi_two_velocities", "H1 Terzaghi, two velocities", requirement, source, Effort::everyday, {}},
                  [](MotionBook& book) {
                    consolidate(LiquidScheme::implicit_drag, {0.05, 0.1, 0.2}, book);
                  }),
      motion_case({"de_boer",
                   "H1 Dynamic column, both phases with inertia",
                   "A step load travels into a porous half-space as de Boer, Ehlers and Liu have it.",
                   "de Boer et al. 1993; benchmarks.md section 3.2.",
                   Effort::everyday,
                   {}},
                  [](MotionBook& book) { de_boer(LiquidScheme::implicit_drag, "two velocities", book); }),
      motion_case({"de_boer_semi_implicit",
                   "H1 Dynamic column, the water's inertia at the points",
                   "A step load travels into a porous half-space as de Boer, Ehlers and Liu have it.",
                   "de Boer et al. 1993; benchmarks.md section 3.2.",
                   Effort::everyday,
                   {}},
                  [](MotionBook& book) { de_boer(LiquidScheme::semi_implicit, "semi-implicit", book); }),
      motion_case({"undrained_load",
                   "H1 Undrained step load and box",
                   "Without time to drain water bears the load, at any step, without swinging.",
                   "Verruijt 2013; physics.md section 1.7.",
                   Effort::quick,
                   {}},
                  undrained_load)};
}

}  // namespace wetfront::verification
