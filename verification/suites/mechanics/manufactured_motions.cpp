#include "verification/suites/mechanics/manufactured_motions.h"
#include "verification/exact/axis_aligned_motion.h"
#include "verification/exact/generalized_vortex.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace wetfront::verification {
namespace {

using std::numbers::pi;

constexpr double young = 1e4, density = 1000;

exact::AxisAlignedSolution axis_aligned(int dim, double poisson, double amplitude) {
  const double lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), shear = young / (2 * (1 + poisson));
  return exact::AxisAlignedSolution({dim, lame, shear, density, amplitude, std::sqrt(young / density), {0, pi, 0}});
}

double period() {
  return 2 / std::sqrt(young / density);
}

/// rms of the error of the displacement over the points, relative to `scale`, at the worst output time.
template <class Position>
double worst_error(const Motion<2>& motion, double scale, const Position& position) {
  double worst = 0;
  for (const auto& cloud : motion.clouds) {
    const double squares = cloud.mean([&](std::size_t p) {
      const auto exact = position(cloud.origin[p], cloud.time);
      return std::pow(cloud.position[p][0] - exact[0], 2) + std::pow(cloud.position[p][1] - exact[1], 2);
    });
    worst = std::max(worst, std::sqrt(squares) / scale);
  }
  return worst;
}

/// Points of one cloud in the order of where they began: each run keeps them in that of its cells.
std::vector<std::size_t> as_seeded(const Cloud<2>& cloud) {
  std::vector<std::size_t> order(cloud.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t p) { return cloud.origin[p]; });
  return order;
}

}  // namespace

double apart(const Motion<2>& one, const Motion<2>& other) {
  double worst = 0;
  for (std::size_t k = 0; k < one.clouds.size(); ++k) {
    const auto &a = one.clouds[k], &b = other.clouds.at(k);
    const auto of_a = as_seeded(a), of_b = as_seeded(b);
    double squares = 0;
    for (std::size_t p = 0; p < of_a.size(); ++p)
      for (std::size_t axis = 0; axis < 2; ++axis)
        squares += std::pow(a.position[of_a[p]][axis] - b.position[of_b.at(p)][axis], 2);
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(of_a.size())));
  }
  return worst;
}

ManufacturedMotion axis_aligned_motion(double amplitude) {
  const auto exact = std::make_shared<exact::AxisAlignedSolution>(axis_aligned(2, 0.3, amplitude));
  ManufacturedMotion out;
  out.scale = amplitude;
  out.problem = [exact](int cells, const mpm::SkeletonScheme& scheme) {
    auto problem =
        dry_problem<2>(rectangle_mesh(1, 1, cells, cells), dry_soil(density, young, 0.3), evenly(period(), 8));
    problem.soils[0].law = mpm::NeoHookean{"suite"};
    problem.skeleton = scheme;
    add_rollers(problem, {"left", "right", "base", "top"});
    problem.initial_velocity = [exact](const std::array<double, 2>& at) {
      const auto v = exact->velocity({at[0], at[1], 0}, 0);
      return std::array{v[0], v[1]};
    };
    problem.body_acceleration = [exact](const std::array<double, 2>& at, double t) {
      const auto b = exact->body_force({at[0], at[1], 0}, t);
      return std::array{b[0], b[1]};
    };
    return problem;
  };
  out.error = [exact, amplitude](const Motion<2>& motion) {
    return worst_error(motion, amplitude, [&](const std::array<double, 2>& x, double t) {
      const auto u = exact->displacement({x[0], x[1], 0}, t);
      return std::array{x[0] + u[0], x[1] + u[1]};
    });
  };
  return out;
}

ManufacturedMotion vortex_motion(double angle) {
  exact::GeneralizedVortex vortex;
  vortex.amplitude = angle;
  const auto exact = std::make_shared<exact::GeneralizedVortexSolution>(vortex);
  constexpr double half = 1.28;  // the ring reaches to 1.25; beyond it all is at rest
  const auto centred = [](const std::array<double, 2>& at) { return std::array{at[0] - half, at[1] - half}; };
  ManufacturedMotion out;
  out.problem = [exact, centred](int cells, const mpm::SkeletonScheme& scheme) {
    auto problem =
        dry_problem<2>(rectangle_mesh(2 * half, 2 * half, cells, cells), dry_soil(1000, 1000, 0.3), evenly(1, 5));
    problem.soils[0].law = mpm::NeoHookean{"suite"};
    problem.skeleton = scheme;
    for (const char* side : {"left", "right", "base", "top"})
      problem.fixities.push_back({side, {true, true, false}, "suite"});
    problem.initial_velocity = [exact, centred](const std::array<double, 2>& at) {
      return exact->velocity(centred(at), 0);
    };
    problem.body_acceleration = [exact, centred](const std::array<double, 2>& at, double t) {
      return exact->body_force(centred(at), t);
    };
    return problem;
  };
  out.error = [exact, centred](const Motion<2>& motion) {
    return worst_error(motion, 1, [&](const std::array<double, 2>& x, double t) {
      const auto at = exact->position(centred(x), t);
      return std::array{at[0] + half, at[1] + half};
    });
  };
  return out;
}

namespace {

struct Ladder {
  ManufacturedMotion motion;
  std::vector<int> cells;
  OrderGate splines;
  std::string crossing;    ///< where points begin to cross cells
  double cells_lost;       ///< of energy, by APIC: smooth_energy
  mpm::Transfer transfer;  ///< FLIP keeps what points of one cell do against each other, APIC is more diffusive
};

void climb(const Ladder& ladder, MotionBook& book) {
  auto figure = figure_frame({"error_over_cells", "Error over the number of cells", "Convergence"}, {"cells", "-"},
                             {"rms error of the displacement, relative", "-"});
  figure.log_x = figure.log_y = true;
  auto second = dashed("second order");
  for (const auto shape : {mpm::ShapeFunctions::quadratic_spline, mpm::ShapeFunctions::linear}) {
    mpm::SkeletonScheme scheme;
    scheme.shape = shape;
    scheme.locking = mpm::LockingRemedy::none;  // nothing locks here
    scheme.transfer = ladder.transfer;
    auto curve = line(scheme_text(scheme));
    for (const int cells : ladder.cells) {
      book.energy = smooth_energy(scheme, cells, ladder.cells_lost);
      book.energy_made = smooth_energy_made(book.energy);
      put(curve, cells,
          ladder.motion.error(
              book.move<2>(fmt::format("{}, {} cells", curve.label, cells), ladder.motion.problem(cells, scheme))));
    }
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
      const double order = std::log2(curve.y[i - 1] / curve.y[i]);
      const std::string text =
          fmt::format("observed order, {}, {:g} to {:g} cells", curve.label, curve.x[i - 1], curve.x[i]);
      if (shape == mpm::ShapeFunctions::quadratic_spline)
        book.page.judge_order("order", text, order, ladder.splines);
      else
        book.page.show("order_linear", text + " (" + ladder.crossing + ")", order, "orders");
    }
    if (shape == mpm::ShapeFunctions::quadratic_spline)
      for (const double cells : curve.x) put(second, cells, curve.y.front() * std::pow(curve.x.front() / cells, 2));
    figure.series.push_back(curve);
  }
  figure.series.push_back(second);
  book.page.draw(figure);
}

/// At 1 rad the ring is sheared by 6: points that were neighbours part by several cells, whatever the shape functions.
void tear(MotionBook& book) {
  auto figure = figure_frame({"error_over_angle", "Error over the angle, 64 cells", "Where points part"},
                             {"largest angle", "rad"}, {"rms error of the displacement over the angle", "-"});
  figure.log_x = figure.log_y = true;
  book.energy = {1, "1", "what is torn apart loses what it has, but makes no more than that"};
  for (const auto shape : {mpm::ShapeFunctions::quadratic_spline, mpm::ShapeFunctions::linear}) {
    mpm::SkeletonScheme scheme;
    scheme.shape = shape;
    scheme.transfer = mpm::Transfer::apic;
    auto curve = line(scheme_text(scheme));
    for (const double angle : {0.1, 0.2, 0.3, 0.5, 1.0}) {
      const auto motion = vortex_motion(angle);
      put(curve, angle,
          motion.error(book.move<2>(fmt::format("{}, {:g} rad", curve.label, angle), motion.problem(64, scheme))) /
              angle);
    }
    book.page.show("torn", "rms error at 1 rad, " + curve.label, curve.y.back(), "1");
    figure.series.push_back(curve);
  }
  book.page.draw(figure);
}

}  // namespace

std::vector<Case> manufactured_motion_cases() {
  const std::string requirement =
      "The error falls with the order 1.5 or more with quadratic splines; where linear cells stop is shown.";
  const std::string source = "Kamojjala et al. 2015; body forces of benchmarks.md section 6.";
  const OrderGate gate{1.5, 2.6, "the issue asks for 1.5; quadratic splines on points as quadrature give about 2"};
  const auto climbing = [gate](const ManufacturedMotion& motion, std::vector<int> cells, std::string crossing,
                               double cells_lost, mpm::Transfer transfer = mpm::Transfer::apic) {
    return [=](MotionBook& book) { climb({motion, cells, gate, crossing, cells_lost, transfer}, book); };
  };
  return {
      motion_case(
          {"axis_aligned_small", "M1 Axis-aligned manufactured motion, small", requirement, source, Effort::quick, {}},
          climbing(axis_aligned_motion(0.002), {8, 16, 32}, "points move by 0.002: none crosses a cell", 1.6,
                   mpm::Transfer::flip)),
      motion_case({"axis_aligned", "M1 Axis-aligned manufactured motion", requirement, source, Effort::everyday, {}},
                  climbing(axis_aligned_motion(), {16, 32, 64},
                           "points move by 0.05: they cross cells, several from 32 on; 8 cells are two to a quarter "
                           "wave: too few for an order",
                           1.6)),
      motion_case(
          {"vortex", "M1 Generalized vortex, 0.1 rad", requirement, source, Effort::everyday, {}},
          climbing(vortex_motion(0.1), {16, 32, 64}, "points turn by up to 0.1 rad: they cross up to 2 cells", 10)),
      motion_case({"vortex_torn",
                   "M1 Generalized vortex, 1 rad",
                   "Where four points per cell no longer hold a body together is shown.",
                   source,
                   Effort::heavy,
                   {}},
                  [](MotionBook& book) { tear(book); })};
}

}  // namespace wetfront::verification
