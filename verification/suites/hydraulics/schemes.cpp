#include "verification/compare/profile.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/column_window.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

using mpm::LiquidScheme;

void draw(CaseBook& book, const ColumnWindow& window, const std::vector<meshes::FieldHistory>& runs) {
  auto figure = figure_frame({"profiles", "Pore pressure over elevation at the window's end", "Profiles"},
                             {"pore pressure", "kPa"}, {"elevation", "m"});
  for (const std::size_t end : {0, 1}) {
    auto solid = line(end == 0 ? "reference, at the start" : "reference, at the end");
    const auto& at = window.yardstick();
    for (std::size_t i = 0; i < at.mesh.node_count(); ++i)
      put(solid, at.snapshots[end].node_pressure[i] / 1e3, at.mesh.nodes[i][0]);
    figure.series.push_back(solid);
  }
  for (const auto& run : runs) {
    auto dots = points(run.solver);
    for (std::size_t c = 0; c < run.mesh.cell_count(); ++c)
      put(dots, run.snapshots.back().cell_pressure[c] / 1e3, run.mesh.cell_centre(c)[1]);
    figure.series.push_back(dots);
  }
  book.draw(figure);
}

/// Seepage on the same cells first, then the schemes with inertia: each against the fine reference and against seepage.
void compare(const ColumnWindow& window, int cells, const std::vector<LiquidScheme>& schemes, CaseBook& book) {
  auto seepage = book.solve("seepage", window.problem(cells, LiquidScheme::seepage));
  book.show("shown", "seepage on the same cells, relative L2 of cell values against the reference",
            window.cell_error(seepage), "1");
  std::vector<meshes::FieldHistory> runs = {seepage};
  for (const LiquidScheme scheme : schemes) {
    auto run = book.solve(scheme_name(scheme), window.problem(cells, scheme));
    book.judge("error",
               fmt::format("{}: relative L2 of cell values after {:.0f} s, {} cells", scheme_name(scheme),
                           window.seconds(), cells),
               window.cell_error(run),
               {0.01, "1",
                "the schemes must agree within 1 %; the reference stands for seepage "
                "on fine cells, as cell averages are not what its nodes hold"});
    runs.push_back(std::move(run));
  }
  draw(book, window, runs);
}

/// Relative L2 of the difference of cell averages at the end, over the pressure and over its change since the start.
struct Difference {
  double of_pressure, of_change;
};
Difference difference(const meshes::FieldHistory& ours, const meshes::FieldHistory& other) {
  const auto &start = other.snapshots.front().cell_pressure, &a = ours.snapshots.back().cell_pressure,
             &b = other.snapshots.back().cell_pressure;
  double off = 0, pressure = 0, change = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    off += std::pow(a[c] - b[c], 2), pressure += std::pow(b[c], 2), change += std::pow(b[c] - start[c], 2);
  }
  return {std::sqrt(off / pressure), std::sqrt(off / change)};
}

void explicit_drag(CaseBook& book) {
  const auto literal = book.solve("explicit", moist_column(8, LiquidScheme::explicit_drag));
  auto problem = moist_column(8, LiquidScheme::implicit_drag);
  const auto implicit = book.solve("implicit-drag, its own step", problem);
  problem.stages[0].largest_step = problem.stages[0].end_time / (10 * implicit.counters.at("steps"));
  const auto small_steps = book.solve("implicit-drag, a tenth of it", problem);
  book.judge("error", "explicit against implicit-drag after 2 s, relative L2 of cell averages",
             difference(implicit, literal).of_pressure, {0.01, "1", "the schemes must agree within 1 %"});
  book.show("shown", "the same over the change within the 2 s", difference(implicit, literal).of_change, "1");
  book.judge("error", "with a tenth of the step, over the change within the 2 s",
             difference(small_steps, literal).of_change,
             {0.01, "1",
              "the stricter reading: most of the pressure is the start's; what is left is implicit drag's "
              "own error in time, of first order"});
  book.show("cost_ratio", "cost of explicit over implicit-drag", literal.cpu_seconds / implicit.cpu_seconds, "times");
}

}  // namespace

std::vector<Case> scheme_cases() {
  const std::string source = "The paper's column, S_min 0.87; the reference gives the start and the yardstick.";
  const std::string requirement = "Inertia of the water changes nothing: every scheme follows Richards' equation.";
  const std::vector<LiquidScheme> schemes = {LiquidScheme::semi_implicit, LiquidScheme::implicit_drag};
  return {{"schemes_30", "Schemes over a window, rain 3e-5 m/s", requirement, source, Effort::quick,
           [=](CaseBook& book) {
             compare(ColumnWindow({3e-5, 0.87}, 0.25, 0.345, book), 20, schemes, book);
           }},
          {"schemes_150", "Schemes over a window, rain 1.5e-4 m/s", requirement, source, Effort::quick,
           [=](CaseBook& book) {
             compare(ColumnWindow({1.5e-4, 0.87}, 0.25, 0.41, book), 40, schemes, book);
           }},
          {"schemes_explicit", "Explicit drag against implicit over 2 s, rain 1.5e-4 m/s",
           "The paper's own scheme and the one that replaces it give the same pressures.", "The paper's sand, moist.",
           Effort::quick, explicit_drag}};
}

}  // namespace wetfront::verification
