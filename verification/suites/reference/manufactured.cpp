#include "verification/exact/manufactured.h"

#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/reference/manufactured_problem.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;
using exact::ManufacturedSolution;

constexpr double end = 6000;  // s

/// Two Gauss points per direction in every cell: no node and no midpoint of either element, and where the error of a
/// quadratic interpolant is largest, so that no superconvergence is sold as order.
void add_gauges(fem::RichardsProblem& problem, int dim, int cells) {
  const double offset = 0.5 / std::numbers::sqrt3;
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c)
    for (int corner = 0; corner < (1 << dim); ++corner) {
      meshes::Point at = problem.mesh.cell_centre(c);
      for (int axis = 0; axis < dim; ++axis) at[axis] += (corner >> axis & 1 ? offset : -offset) / cells;
      problem.gauges.push_back({"", at});
    }
}

double rms_error(const meshes::FieldHistory& history, const ManufacturedSolution& solution, double unit_weight) {
  double squares = 0;
  for (const auto& gauge : history.gauges)
    squares += std::pow(gauge.pressure.back() / unit_weight - solution.head(gauge.position, end), 2);
  return std::sqrt(squares / history.gauges.size());
}

struct Ladder {
  int degree;
  std::vector<int> cells;
  OrderGate gate;
};

void climb(const exact::Manufactured& box, int dim, const Ladder& ladder, reports::Figure& figure, CaseBook& book) {
  const ManufacturedSolution solution(box);
  reports::Series measured = line(fmt::format("degree {}", ladder.degree), ladder.degree);
  reports::Series slope = dashed(fmt::format("order {}", ladder.degree + 1), ladder.degree);
  for (const int cells : ladder.cells) {
    fem::RichardsProblem problem = manufactured_problem(box, dim, cells);
    problem.degree = ladder.degree;
    add_gauges(problem, dim, cells);
    const auto history = book.solve(fmt::format("degree {}, {} cells", ladder.degree, cells), problem);
    put(measured, cells, rms_error(history, solution, problem.unit_weight));
    put(slope, cells, measured.y.front() * std::pow(double(ladder.cells.front()) / cells, ladder.degree + 1));
  }
  const std::size_t last = measured.y.size() - 1;
  book.judge_order("order",
                   fmt::format("degree {}: observed order of the rms error at Gauss points, {} to {} cells",
                               ladder.degree, ladder.cells[last - 1], ladder.cells[last]),
                   std::log2(measured.y[last - 1] / measured.y[last]), ladder.gate);
  book.show("shown", fmt::format("degree {}: rms error at Gauss points, {} cells", ladder.degree, ladder.cells[last]),
            measured.y[last], "m");
  figure.series.insert(figure.series.end(), {measured, slope});
}

Case manufactured(int dim, bool van_genuchten, const std::vector<Ladder>& ladders, Effort effort) {
  Case test;
  test.name = fmt::format("manufactured_{}d_{}", dim, van_genuchten ? "van_genuchten" : "exponential");
  test.title = fmt::format("Manufactured solution, {} dimension{}, {}", dim, dim > 1 ? "s" : "",
                           van_genuchten ? "van Genuchten" : "exponential");
  test.requirement =
      "The full operator (retention, conductivity, gravity, anisotropy) converges at the element's order.";
  test.source = "exact/manufactured.h; the source is the operator applied to the head, derivatives by hand.";
  test.effort = effort;
  test.run = [=](CaseBook& book) {
    auto figure =
        figure_frame({"error_over_cells", "rms error at Gauss points over cells per direction", "Convergence"},
                     {"cells", "-"}, {"rms error of the head", "m"});
    figure.log_x = figure.log_y = true;
    for (const Ladder& ladder : ladders) climb(manufactured_box(dim, van_genuchten), dim, ladder, figure, book);
    book.draw(figure);
  };
  return test;
}

}  // namespace

exact::Manufactured manufactured_box(int dim, bool van_genuchten) {
  exact::Manufactured box;
  if (van_genuchten)
    box.soil = exact::VanGenuchten{0.08, 0.43, 4.0, 1.8, 1e-5};
  else
    box.soil = exact::ManufacturedGardner{0.06, 0.40, 3.0, 1e-5};
  box.gravity[dim - 1] = -1;
  if (dim == 2) box.anisotropy = {2, 0.7, 1, 0.3, 0, 0};
  if (dim == 3) box.anisotropy = {2, 0.7, 1, 0.3, -0.2, 0.1};
  box.mean = -0.9;
  // sin(w t) sin(k.x + p) is the sum of two travelling waves of half the amplitude.
  const auto standing = [&](double amplitude, std::array<double, 3> k, double frequency, double phase) {
    for (int axis = dim; axis < 3; ++axis) k[axis] = 0;
    box.waves.push_back({0.5 * amplitude, k, -frequency, phase + 0.5 * std::numbers::pi});
    box.waves.push_back({-0.5 * amplitude, k, frequency, phase + 0.5 * std::numbers::pi});
  };
  standing(0.3, {4.0, 2.5, 1.5}, 2e-4, 0.4);
  standing(0.2, {-2.0, 4.5, 3.5}, 3e-4, 1.1);
  return box;
}

fem::RichardsProblem manufactured_problem(const exact::Manufactured& box, int dim, int cells) {
  const auto solution = std::make_shared<ManufacturedSolution>(box);
  fem::RichardsProblem problem;
  problem.mesh = box_mesh(dim, {1, 1, 1}, {cells, cells, cells});
  problem.gravity_direction = box.gravity;
  if (const auto* soil = std::get_if<exact::VanGenuchten>(&box.soil)) {
    problem.soils = {van_genuchten_soil(*soil)};
  } else {
    const auto& gardner = std::get<exact::ManufacturedGardner>(box.soil);
    problem.soils = {gardner_soil(gardner.theta_r, gardner.theta_s, gardner.alpha, gardner.conductivity)};
  }
  problem.soils[0].anisotropy = box.anisotropy;
  for (const auto& side : problem.mesh.sides) {
    fem::HeadSide held{side.name, 0};
    held.varying = [solution](const meshes::Point& at, double t) { return solution->head(at, t); };
    problem.boundary.push_back(held);
  }
  problem.source = [solution](const meshes::Point& at, double t) { return solution->source(at, t); };
  start_from(problem, [&](const meshes::Point& at) { return solution->head(at, 0); });
  problem.end_time = end;
  problem.output_times = {end};
  problem.tolerance = 1e-8;
  return problem;
}

std::vector<Case> manufactured_cases() {
  const OrderGate linear{1.9, 2.1, "linear elements: second order; the issue asks for at least 1.9"};
  const OrderGate quadratic{2.8, 3.2, "quadratic elements: third order; the issue asks for at least 2.8"};
  const std::vector<Ladder> lines = {{1, {16, 32, 64, 128}, linear}, {2, {4, 8, 16, 32}, quadratic}};
  const std::vector<Ladder> squares = {{1, {8, 16, 32}, linear}, {2, {4, 8, 16}, quadratic}};
  const std::vector<Ladder> cubes = {{1, {4, 8, 16}, linear}, {2, {2, 4, 8}, quadratic}};
  return {manufactured(1, true, lines, Effort::quick),      manufactured(1, false, lines, Effort::quick),
          manufactured(2, true, squares, Effort::everyday), manufactured(2, false, squares, Effort::everyday),
          manufactured(3, true, cubes, Effort::heavy),      manufactured(3, false, cubes, Effort::heavy)};
}

}  // namespace wetfront::verification
