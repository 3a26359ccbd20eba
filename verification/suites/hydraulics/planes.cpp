#include "verification/compare/profile.h"
#include "verification/present/contours.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/flume_slope.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/levee.h"
#include "verification/suites/on_points.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

struct Size {
  int along, over;
};

/// A vertical section whose yardstick is the reference on a finer mesh.
struct Section {
  fem::RichardsProblem (*problem)(int cells_along, int cells_over);
  std::vector<Size> ladder;  ///< each twice the one before
  Size reference;
  double reference_tolerance;
  Gate pressure, water;  ///< on the finest of the ladder: nodal pressure, and what passed each side
  OrderGate order;
};

std::string text(const Size& size) {
  return fmt::format("{} x {} cells", size.along, size.over);
}

/// Relative L2 of the nodal pressure, one per output time.
std::vector<double> errors(const meshes::FieldHistory& ours, const meshes::FieldHistory& reference) {
  const auto expected = pressure_at_nodes(reference, ours.mesh);
  const auto weight = node_weights(ours.mesh, reference.mesh);
  std::vector<double> found;
  for (std::size_t t = 0; t < expected.size(); ++t)
    found.push_back(relative_l2(ours.snapshots[t].node_pressure, expected[t], weight));
  return found;
}

/// Water that passed a side net of rain [m2], at the end.
double left_through(const meshes::FieldHistory& history, const std::string& side) {
  double sum = 0;
  for (const auto& ledger : history.sides)
    if (ledger.side == side) sum += ledger.outflow.back() - ledger.asked.back() + ledger.run_off.back();
  return sum;
}

void judge_sides(CaseBook& book, const Section& section, const meshes::FieldHistory& ours,
                 const meshes::FieldHistory& reference) {
  double passed = 0;
  for (const auto& side : reference.sides) passed += std::abs(left_through(reference, side.side));
  reports::Table table{"Water through the sides by the end",
                       "Flux audit",
                       "Net, out of the soil > 0.",
                       {"side", "material points [m2]", "reference [m2]"},
                       {}};
  for (const auto& side : reference.sides) {
    const double a = left_through(ours, side.side), b = left_through(reference, side.side);
    table.rows.push_back({side.side, fmt::format("{:.5f}", a), fmt::format("{:.5f}", b)});
    book.judge("side_flux",
               fmt::format("water through {}, over all that passed: {:.5g} against {:.5g} m2", side.side, a, b),
               std::abs(a - b) / passed, section.water);
  }
  book.tabulate(table);
}

void draw(CaseBook& book, const meshes::FieldHistory& ours, const meshes::FieldHistory& reference) {
  auto figure = figure_frame({"water_table", "Water table (p = 0)", "Profiles"}, {"x", "m"}, {"y", "m"});
  auto frame = outline(ours.mesh);
  frame.colour = 7;
  figure.series.push_back(frame);
  for (std::size_t t = 0; t < reference.snapshots.size(); ++t) {
    const int colour = static_cast<int>(t);
    auto solid = contour(reference.mesh, reference.snapshots[t].node_pressure, 0);
    auto dots = contour(ours.mesh, ours.snapshots[t].node_pressure, 0);
    const std::string at = fmt::format("{:.3g} h", reference.snapshots[t].time / 3600);
    solid.label = "reference, " + at, dots.label = "material points, " + at;
    solid.style = reports::Series::Style::line, dots.style = reports::Series::Style::dashed;
    solid.colour = dots.colour = colour;
    figure.series.push_back(solid);
    figure.series.push_back(dots);
  }
  book.draw(figure);
}

void run(const Section& section, CaseBook& book) {
  fem::RichardsProblem finest = section.problem(section.reference.along, section.reference.over);
  finest.tolerance = section.reference_tolerance;
  const auto reference = book.solve("reference, " + text(section.reference), finest);
  auto figure = figure_frame({"error_over_cells", "Error over the number of cells along", "Convergence"},
                             {"cells", "-"}, {"relative L2 of the nodal pressure", "-"});
  figure.log_x = figure.log_y = true;
  auto measured = line("seepage");
  reports::Table table{"Relative L2 of the nodal pressure", "Convergence", "", {"mesh"}, {}};
  for (const double time : finest.output_times) table.header.push_back(fmt::format("{:.3g} h", time / 3600));
  meshes::FieldHistory ours;
  for (const Size& size : section.ladder) {
    ours = book.solve(text(size), on_points(section.problem(size.along, size.over)));
    const auto found = errors(ours, reference);
    std::vector<std::string> row = {text(size)};
    for (const double error : found) row.push_back(fmt::format("{:.2e}", error));
    table.rows.push_back(row);
    put(measured, size.along, *std::ranges::max_element(found));
  }
  book.judge("error", "relative L2 of the nodal pressure, the worst output time, " + text(section.ladder.back()),
             measured.y.back(), section.pressure);
  if (measured.y.size() > 1)
    book.judge_order(
        "order",
        fmt::format("observed order between {:g} and {:g} cells along", *(measured.x.end() - 2), measured.x.back()),
        std::log2(*(measured.y.end() - 2) / measured.y.back()), section.order);
  book.tabulate(table);
  figure.series = {measured};
  book.draw(figure);
  judge_sides(book, section, ours, reference);
  draw(book, ours, reference);
}

}  // namespace

std::vector<Case> plane_cases() {
  const Gate water{0.01, "1",
                   "a hundredth of what passed all sides: conservation leaves only when and where it passes"};
  const Gate thin{0.03, "1",
                  "cells of 0.2 m under a front thinner than they are (measured 2.0 %, of second order); the fine form "
                  "has cells half as large and a third of this"};
  const OrderGate front{1.4, 2.2, "second order but for the front, which the coarser mesh does not resolve"};
  const Section flume{flume_slope, {{58, 3}, {115, 6}}, {230, 12}, 1e-4, thin, water, front};
  const Gate fine{0.01, "1", "cells half as large as in the everyday form, a third of its error"};
  const Section fine_flume{flume_slope, {{115, 6}, {230, 12}}, {460, 24}, 1e-4, fine, water, front};
  const Gate wide{0.1, "1",
                  "cells of 0.5 m: the front behind the wetted slope is narrower than one; against a reference only "
                  "twice as fine. What crosses the sides is gated ten times tighter"};
  const OrderGate rough{0.7, 2.2, "the yardstick is only twice as fine and the front unresolved: it must fall"};
  const Section dike{levee, {{14, 3}, {28, 6}}, {56, 12}, 1e-3, wide, water, rough};
  const std::string flume_source =
      "Moriwaki et al. 2004 after the seed paper, Table 1 with S_min 0.087; own reference.";
  const std::string flume_requirement = "Rain on the flume's slope soaks in and leaves through the toe.";
  return {{"flume_infiltration", "The flume's infiltration stage", flume_requirement, flume_source, Effort::everyday,
           [flume](CaseBook& book) { run(flume, book); }},
          {"flume_infiltration_fine", "The flume's infiltration stage on the mesh of the paper's size",
           flume_requirement, flume_source, Effort::heavy, [fine_flume](CaseBook& book) { run(fine_flume, book); }},
          {"levee", "A levee: rising water, seepage face and rain",
           "Water enters where the level rises, leaves through the landside and falls as rain on top, side by side as "
           "the reference has it.",
           "Own geometry: cases/levee; own reference.", Effort::everyday, [dike](CaseBook& book) { run(dike, book); }}};
}

}  // namespace wetfront::verification
