#include "verification/exact/soil_strength.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double half_width = 1, cohesion = 1e3, density = 2000;

/// Half of a strip footing, smooth, pushed slowly into weightless soil; the left side is the plane of symmetry. The
/// push goes with the stiffness, 12 to 13 times c H/E at phi = 0: the fine footing is pushed a quarter as far into soil
/// four times as stiff. The plateau is reached at three quarters of it; what is pushed on from there only heaves soil
/// without a remedy through the border of its mesh (measured at 16 cells: slope of the last 15 % .007 of the elastic
/// one). With friction 60 crossings left a wave of 2 % on the load (slope .17); 120 leave .03.
struct Footing {
  double friction;        ///< degrees; associated
  int cells;              ///< under half of the footing
  double width, depth;    ///< of the soil [m]
  double push;            ///< displacement at the end [m]
  double young = 1e6;     ///< stiff enough that the heave beside the footing stays below the border of the mesh
  double crossings = 60;  ///< of the depth by a wave, while it is pushed
};

mpm::Problem<2> problem_of(const Footing& f, mpm::LockingRemedy remedy) {
  const double h = half_width / f.cells;
  const auto along = static_cast<int>(std::lround(f.width / h)), over = static_cast<int>(std::lround(f.depth / h));
  auto mesh = rectangle_mesh(f.width, f.depth, along, over);
  split_side(mesh, "top", "footing", [](const meshes::Point& at) { return at[0] < half_width; });
  const mpm::Elastic elastic{f.young, 0.3, "suite"};
  const double wave = std::sqrt(1.3462 * f.young / density), duration = f.crossings * f.depth / wave;
  auto problem = dry_problem<2>(
      std::move(mesh),
      frictional_soil(density, elastic, {f.friction * degree, cohesion, f.friction * degree, {}, "suite"}),
      evenly(duration, 40));
  problem.skeleton.locking = remedy;
  add_rollers(problem, {"left"});
  // Rough: on a smooth base the whole body gives way at less than Prandtl's load (0.9 of it, 2 m deep and 4 m wide).
  for (const char* side : {"right", "base"}) problem.fixities.push_back({side, {true, true, false}, "suite"});
  mpm::MovingSide pushing;
  pushing.side = "footing";
  pushing.velocity[1] = -f.push / duration;
  // reached within the first twentieth, so that no wave is sent
  pushing.factor = {{0, 0.05 * duration}, {0, 1}};
  pushing.origin = "suite";
  problem.skeleton_boundary.push_back(pushing);
  problem.stages[0].local_damping = 0.05;
  return problem;
}

/// Force on the whole footing over the width on which it acts. Without weight every level bears the footing's force: it
/// is the mean of the vertical stress over the body times its width. Linear cells carry the footing's velocity half a
/// cell beyond its edge (Sloan & Randolph 1982), so it acts on as much.
double effective_half_width(const Footing& f) {
  return half_width + 0.5 * half_width / f.cells;
}
double pressure_under(const Cloud<2>& cloud, const Footing& f) {
  double force = 0, volume = 0;
  for (std::size_t p = 0; p < cloud.size(); ++p)
    force -= cloud.volume[p] * cloud.stress[p][1], volume += cloud.volume[p];
  return force / volume * f.width / effective_half_width(f);
}

/// Slope of the last 15 % of a load-displacement curve (least squares) over that of its rise between a tenth and four
/// tenths of the load expected: 0 where the soil flows at a constant load, 1 where it is still elastic.
double slope_at_the_end(const reports::Series& curve, double expected) {
  const auto first_above = [&](double load) {
    return static_cast<std::size_t>(std::ranges::find_if(curve.y, [load](double y) { return y > load; }) -
                                    curve.y.begin());
  };
  const std::size_t low = first_above(0.1 * expected), high = first_above(0.4 * expected);
  const double rise = (curve.y.at(high) - curve.y.at(low)) / (curve.x.at(high) - curve.x.at(low));
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (!(curve.x[k] > 0.85 * curve.x.back())) continue;
    n += 1, x += curve.x[k], y += curve.y[k], xx += curve.x[k] * curve.x[k], xy += curve.x[k] * curve.y[k];
  }
  return (n * xy - x * y) / (n * xx - x * x) / rise;
}

void push(const Footing& f, MotionBook& book) {
  const double expected = exact::bearing_factor_cohesion(f.friction * degree);
  auto figure = figure_frame({"load", "Load over settlement", "Load-displacement"}, {"settlement over width", "%"},
                             {"pressure over cohesion", "-"});
  auto level = dashed(fmt::format("Prandtl, {:.3f}", expected));
  put(level, 0, expected);
  put(level, 100 * f.push / (2 * half_width), expected);
  figure.series = {level};
  for (const auto remedy : {mpm::LockingRemedy::b_bar, mpm::LockingRemedy::none}) {
    const std::string label = remedy == mpm::LockingRemedy::b_bar ? "B-bar" : "no remedy";
    const auto motion = book.move<2>(label, problem_of(f, remedy));
    auto curve = line(label);
    double last = 0;
    int averaged = 0;
    for (const auto& cloud : motion.clouds) {
      const double pressure = pressure_under(cloud, f) / cohesion;
      put(curve, 100 * f.push / (2 * half_width) * cloud.time / motion.clouds.back().time, pressure);
      if (cloud.time > 0.85 * motion.clouds.back().time) last += pressure, ++averaged;
    }
    last /= averaged;
    figure.series.push_back(curve);
    if (remedy == mpm::LockingRemedy::b_bar) {
      book.page.expect("error", "pressure at failure over cohesion, B-bar", last, expected,
                       {0.05, "1", "the issue's; a corner of the footing within a cell"});
      book.page.judge("plateau", "slope of the load where it is taken, over that of its elastic rise, B-bar",
                      std::abs(slope_at_the_end(curve, expected)),
                      {0.05, "1", "a bearing capacity is a load that no longer grows"});
      const double over_geometric_width = last * effective_half_width(f) / half_width;
      book.page.show(
          "geometric",
          fmt::format("the same over the footing's own width, {} cells under half of it, over Prandtl's, less 1",
                      f.cells),
          over_geometric_width / expected - 1, "1");
    } else {
      book.page.show("locking", "pressure at the end over cohesion, no remedy, over Prandtl's, less 1",
                     last / expected - 1, "1");
    }
  }
  book.page.draw(figure);
}

}  // namespace

std::vector<Case> footing_cases() {
  const std::string requirement =
      "A smooth strip on weightless soil fails at Prandtl's pressure; linear cells need a remedy.";
  const std::string source = "Prandtl 1921; benchmarks.md section 6.";
  const auto pushing = [](Footing f) { return [f](MotionBook& book) { push(f, book); }; };
  return {
      motion_case({"prandtl_0", "M2 Prandtl footing, phi = 0", requirement, source, Effort::everyday, {}},
                  pushing({0, 8, 5, 2.5, 0.03})),
      motion_case({"prandtl_20", "M2 Prandtl footing, phi = 20, associated", requirement, source, Effort::everyday, {}},
                  pushing({20, 6, 7, 3, 0.03, 2e6, 120})),
      motion_case({"prandtl_0_fine", "M2 Prandtl footing, phi = 0, finer", requirement, source, Effort::heavy, {}},
                  pushing({0, 16, 5, 2.5, 0.008, 4e6})),
      motion_case({"prandtl_20_fine", "M2 Prandtl footing, phi = 20, finer", requirement, source, Effort::heavy, {}},
                  pushing({20, 9, 7, 3, 0.015, 4e6, 120}))};
}

}  // namespace wetfront::verification
