#include "verification/compare/profile.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/column_window.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

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

}  // namespace

std::vector<Case> scheme_cases() {
  const std::string source = "The paper's column, S_min 0.87; the reference gives the start and the yardstick.";
  const std::string requirement = "Inertia of the water changes nothing: every scheme follows Richards' equation.";
  const std::vector<LiquidScheme> schemes = {LiquidScheme::implicit_drag};
  return {{"schemes_30", "Schemes over a window, rain 3e-5 m/s", requirement, source, Effort::everyday,
           [=](CaseBook& book) {
             compare(ColumnWindow({3e-5, 0.87}, 0.25, 0.345, book), 20, schemes, book);
           }},
          {"schemes_150", "Schemes over a window, rain 1.5e-4 m/s", requirement, source, Effort::everyday,
           [=](CaseBook& book) {
             compare(ColumnWindow({1.5e-4, 0.87}, 0.25, 0.41, book), 40, schemes, book);
           }}};
}

}  // namespace wetfront::verification
