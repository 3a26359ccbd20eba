#include "verification/exact/srivastava_yeh_slope.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/reference/closed_forms.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

/// The seed paper's sand under rain that ponds, pauses and ponds again over a draining base: water enters, runs off,
/// leaves, and the column fills.
fem::RichardsProblem ponding_problem(double tolerance, fem::Integrator integrator) {
  constexpr double conductivity = 2.943e-4;
  fem::RichardsProblem problem = column(1.2, 120, 0, {1000, 2000, 3600});
  problem.soils = {van_genuchten_soil({0.46 * 0.087, 0.46, 9810 / 4350.0, 1 / (1 - 0.61), conductivity})};
  problem.soils[0].specific_storage = 0.46 * 9810 / 0.2e9;
  problem.boundary = {
      fem::RainSide{"top", {{0, 1500, 2000}, {1.5 * conductivity, 0.1 * conductivity, 2 * conductivity}}},
      fem::FreeDrainageSide{"base"}};
  start_from(problem, [](const meshes::Point& at) { return std::max(-at[0], -10e3 / 9810); });
  problem.tolerance = tolerance;
  problem.integrator = integrator;
  return problem;
}

reports::Figure ledger_figure(const meshes::FieldHistory& history) {
  auto figure = figure_frame({"ledger", "Where the rain went", "Flux audit"}, {"time", "s"}, {"water", "m"});
  reports::Series asked = dashed("rain"), taken = line("taken up"), run_off = line("run off"), left = line("drained");
  for (const auto& row : history.ledger) {
    put(asked, row.time, row.rain_asked);
    put(taken, row.time, row.infiltrated);
    put(run_off, row.time, row.run_off);
    put(left, row.time, row.outflow);
  }
  figure.series = {asked, taken, run_off, left};
  return figure;
}

void ponding(CaseBook& book) {
  const auto finest = book.solve("BDF, 1e-8", ponding_problem(1e-8, fem::Integrator::bdf));
  struct Run {
    const char* label;
    fem::Integrator integrator;
    double tolerance, gate;
    const char* reason;
  };
  for (const Run& run :
       {Run{"BDF, 1e-4", fem::Integrator::bdf, 1e-4, 1e-3, "a tenth of a per cent at the default tolerance"},
        Run{"BDF, 1e-6", fem::Integrator::bdf, 1e-6, 1e-5, "ten times the tolerance"},
        Run{"backward Euler, 1e-4", fem::Integrator::backward_euler, 1e-4, 1e-2,
            "first order: 1e-4 per step adds up"}}) {
    const auto history = book.solve(run.label, ponding_problem(run.tolerance, run.integrator));
    book.expect("infiltration", fmt::format("water run off, {} [m]", run.label), history.ledger.back().run_off,
                finest.ledger.back().run_off, {run.gate, "1", run.reason});
  }
  book.show("shown", "share of the rain that ran off (there must be some)",
            finest.ledger.back().run_off / finest.ledger.back().rain_asked, "1");
  book.draw(ledger_figure(finest));
}

}  // namespace

ClosedFormCase sloping_layer_case(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const exact::SrivastavaYehSlope layer{10, cm_per_hour, 0.06, 0.40, 1.0, angle, 0.1 * cm_per_hour, 0.9 * cm_per_hour,
                                        0};
  const auto solution = std::make_shared<exact::SrivastavaYehSlopeSolution>(layer);
  const auto along_normal = [angle](const meshes::Point& at) {
    return std::clamp((at[1] - std::tan(angle) * at[0]) * std::cos(angle), 0.0, 1.0);
  };
  ClosedFormCase test;
  test.name = degrees == 30 ? "sloping_layer" : fmt::format("sloping_layer_{:g}", degrees);
  test.title = fmt::format("Rain on an infinite slope of {:g} degrees, periodic sides", degrees);
  test.requirement = "A layer on a slope wets along its normal as the transformed closed form says.";
  test.source = "Srivastava & Yeh 1991 with the transform of Iverson 2000, WRR 36:1897.";
  test.effort = Effort::everyday;
  test.problem = [=](int cells) {
    fem::RichardsProblem problem;
    problem.mesh = rectangle_mesh(1, 1 / std::cos(angle), 2, cells);
    for (auto& node : problem.mesh.nodes) node[1] += std::tan(angle) * node[0];
    problem.gravity_direction = {0, -1, 0};
    problem.soils = {gardner_soil(layer.theta_r, layer.theta_s, layer.alpha, layer.conductivity)};
    problem.boundary = {fem::RainSide{"top", {{0}, {layer.rain_after}}}, fem::HeadSide{"base", 0},
                        fem::PeriodicSides{"left", "right"}};
    start_from(problem, [&](const meshes::Point& at) { return solution->head(along_normal(at), 0); });
    problem.output_times = {1 * hour, 5 * hour, 10 * hour, 20 * hour, 50 * hour, 100 * hour};
    problem.end_time = 100 * hour;
    return problem;
  };
  test.head = [=](const meshes::Point& at, double t) { return solution->head(along_normal(at), t); };
  test.ladder = {50, 100, 200};
  test.gate = {3.5e-4, 100, "gate R2's 3.5e-4 at 100 cells: the shear adds a direction of gravity, no error"};
  test.order = {1.9, 2.1, "linear elements are of second order"};
  return test;
}

std::vector<Case> rain_cases() {
  return {{"ponding_balance", "Water balance of rain that ponds, pauses and ponds again",
           "What rains, runs off, enters and drains adds up at every tolerance.",
           "Soil of Lee et al. 2021, Table 1; rain of 1.5, 0.1 and 2 Ks.", Effort::quick, ponding},
          as_case(sloping_layer_case(30))};
}

}  // namespace wetfront::verification
