#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/reference/celia_problem.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

/// Heads [cm] by depth [cm] at one time; `front`: the place is in the front, where the gate is on the place instead.
struct Printed {
  double depth, head;
  bool front = false;
};
struct PrintedTime {
  double time;  ///< s
  std::vector<Printed> heads;
};

const char* behind_reason = "gate R8: 0.5 cm of head behind the front";
const char* front_reason = "gate R8: 0.5 cm; the height at which the reference passes the printed head";

reports::Figure profile_figure(const std::vector<PrintedTime>& printed, const meshes::FieldHistory& history,
                               double height) {
  reports::Figure figure =
      figure_frame({"profiles", "Pressure head over depth", "Profiles"}, {"pressure head", "cm"}, {"depth", "cm"});
  int colour = 0;
  for (std::size_t s = 0; s < printed.size(); ++s, ++colour) {
    const std::string at = fmt::format("{:.4g} s", printed[s].time);
    reports::Series ours = line("computed, " + at, colour);
    reports::Series table = points("printed, " + at, colour);
    const std::vector<double> heads = heads_of(history.snapshots[s]);
    for (std::size_t i = 0; i < heads.size(); ++i) put(ours, heads[i] / cm, (history.mesh.nodes[i][0] - height) / cm);
    for (const Printed& p : printed[s].heads) put(table, p.head, -p.depth);
    figure.series.insert(figure.series.end(), {ours, table});
  }
  return figure;
}

void judge_heads(CaseBook& book, const std::vector<PrintedTime>& printed, const meshes::FieldHistory& history,
                 double height) {
  for (std::size_t s = 0; s < printed.size(); ++s) {
    const std::vector<double> heads = heads_of(history.snapshots[s]);
    double worst = 0, where = 0;
    for (const Printed& p : printed[s].heads) {
      if (p.front) {
        const double depth = (height - height_where(history.mesh, heads, p.head * cm)) / cm;
        book.expect("front", fmt::format("depth of the head {:g} cm after {:g} s [cm]", p.head, printed[s].time), depth,
                    p.depth, {0.5, "cm", front_reason});
        continue;
      }
      const double off = std::abs(head_at_height(history.mesh, heads, height - p.depth * cm) / cm - p.head);
      if (off >= worst) worst = off, where = p.depth;
    }
    book.judge("error",
               fmt::format("heads behind the front after {:g} s, the worst at {:g} cm", printed[s].time, where), worst,
               {0.5, "cm", behind_reason});
  }
  book.draw(profile_figure(printed, history, height));
}

void judge_inflow(CaseBook& book, const meshes::FieldHistory& history, double printed) {
  book.expect("infiltration", "water through the top by the end [cm]", -history.counters.at("outflow through top") / cm,
              printed, {1e-3, "1", "gate R8: within 0.1 % of the converged inflow"});
  const auto& first = history.ledger.front();
  const auto& last = history.ledger.back();
  book.judge("water_balance", "|change of stored water / net inflow - 1|",
             std::abs((last.stored - first.stored) / (last.infiltrated - last.outflow) - 1),
             {1e-8, "1", "gate R8: Celia's mass ratio is 1 for the mixed form, whatever the step"});
}

}  // namespace

void judge_celia_sand(CaseBook& book, const meshes::FieldHistory& history) {
  const std::vector<PrintedTime> printed = {{360,
                                             {{2, -21.0794},
                                              {6, -22.3471},
                                              {10, -25.0757},
                                              {12, -27.8025},
                                              {14, -32.8726},
                                              {16, -43.044, true},
                                              {18, -55.985, true},
                                              {20, -60.803},
                                              {22, -61.439}}}};
  judge_heads(book, printed, history, 0.4);
}

void judge_celia_new_mexico(CaseBook& book, const meshes::FieldHistory& history) {
  const std::vector<PrintedTime> printed = {
      {6 * hour, {{10, -85.9777}, {20, -126.0072}, {25, -322.5876, true}}},
      {12 * hour, {{10, -79.9318}, {20, -90.8202}, {25, -101.8094}, {30, -123.3795}, {35, -191.6184}}},
      {24 * hour,
       {{10, -76.8714},
        {20, -80.2799},
        {25, -82.9675},
        {30, -86.7268},
        {35, -92.1617},
        {40, -100.4566},
        {46, -118.3833},
        {50, -142.8776},
        {54, -209.8121, true},
        {56, -358.91, true}}}};
  judge_heads(book, printed, history, 1.0);
}

namespace {

void sand(CaseBook& book) {
  const auto history = book.solve("200 cells", celia_sand(200));
  judge_celia_sand(book, history);
  judge_inflow(book, history, 2.3811);
}

void new_mexico(CaseBook& book) {
  const auto history = book.solve("800 cells", celia_new_mexico(800));
  judge_celia_new_mexico(book, history);
  judge_inflow(book, history, 4.1138);
}

/// Celia's point: the mass ratio stays 1 whatever the step; the error falls with it, and nothing else does.
void against_time_step(CaseBook& book) {
  const meshes::FieldHistory yardstick = [&] {
    fem::RichardsProblem problem = celia_new_mexico(100);
    problem.tolerance = 1e-8;
    return book.solve("BDF, 1e-8", problem);
  }();
  const std::vector<double> exact = heads_of(yardstick.snapshots.back());
  reports::Series error = line("error of the head after 24 h"), slope = dashed("first order");
  double worst_ratio = 0;
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    fem::RichardsProblem problem = celia_new_mexico(100);
    problem.integrator = fem::Integrator::backward_euler;
    problem.tolerance = tolerance;
    const auto history = book.solve(fmt::format("backward Euler, {:g}", tolerance), problem);
    const auto &first = history.ledger.front(), &last = history.ledger.back();
    worst_ratio = std::max(worst_ratio, std::abs((last.stored - first.stored) / (last.infiltrated - last.outflow) - 1));
    put(error, problem.end_time / history.counters.at("steps"), relative_l2(heads_of(history.snapshots.back()), exact));
    put(slope, error.x.back(), error.y.front() * error.x.back() / error.x.front());
  }
  book.judge("water_balance", "|mass ratio - 1|, the worst of all step sizes", worst_ratio,
             {1e-8, "1", "gate R8: the mixed form conserves mass at any step"});
  const std::size_t n = error.x.size();
  book.judge_order(
      "order", "observed order of backward Euler over its mean step",
      std::log(error.y[n - 2] / error.y[n - 1]) / std::log(error.x[n - 2] / error.x[n - 1]),
      {0.75, 1.25,
       "first order; the steps of one run differ by orders of magnitude, so their mean is a rough measure"});
  reports::Figure figure = figure_frame({"error_over_step", "Error over the mean time step, 100 cells", "Convergence"},
                                        {"mean step", "s"}, {"relative L2 error of the head", "-"});
  figure.log_x = figure.log_y = true;
  figure.series = {error, slope};
  figure.note = fmt::format("mass ratio 1 within {:.1e} at every step size", worst_ratio);
  book.draw(figure);
}

}  // namespace

fem::RichardsProblem celia_sand(int cells) {
  fem::RichardsProblem problem = column(0.4, cells, -0.615, {360});
  fem::Soil soil;
  soil.name = "Celia's sand";
  // a printed for centimetres
  soil.retention = fem::HaverkampRetention{0.075, 0.287, 1.611e6 * std::pow(0.01, 3.96), 3.96};
  soil.conductivity = fem::HaverkampConductivity{1.175e6 * std::pow(0.01, 4.74), 4.74};
  soil.saturated_conductivity = 0.00944 * cm;
  problem.soils = {soil};
  problem.boundary = {fem::HeadSide{"top", -0.207}, fem::HeadSide{"base", -0.615}};
  return problem;
}

fem::RichardsProblem celia_new_mexico(int cells) {
  fem::RichardsProblem problem = column(1.0, cells, -10, {6 * hour, 12 * hour, 24 * hour});
  problem.soils = {van_genuchten_soil({0.102, 0.368, 3.35, 2, 0.00922 * cm})};
  problem.boundary = {fem::HeadSide{"top", -0.75}, fem::HeadSide{"base", -10}};
  return problem;
}

std::vector<Case> celia_cases() {
  const std::string source = "Celia, Bouloutas & Zarba 1990, WRR 26:1483; converged tables of the design notes (2.1).";
  return {{"celia_sand", "R8 Celia, sand, 360 s", "Haverkamp's sand wets as the converged table says.", source,
           Effort::quick, sand},
          {"celia_new_mexico", "R8 Celia, New Mexico soil, 24 h", "A dry column wets as the converged table says.",
           source, Effort::everyday, new_mexico},
          {"celia_time_step", "R8 Celia, New Mexico soil, error over the time step",
           "The mixed form conserves mass at any step; only accuracy depends on it.", source, Effort::everyday,
           against_time_step}};
}

}  // namespace wetfront::verification
