#include "verification/suites/closed_form_case.h"

#include "verification/compare/balance.h"
#include "verification/compare/verdict.h"
#include "verification/present/figure_frame.h"
#include "verification/present/tables.h"
#include "verification/run/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

struct Rung {
  int cells;
  meshes::FieldHistory history;
  std::vector<double> error;  ///< relative L2 of the head over the nodes, one per output time
};

Rung climb(const ClosedFormCase& test, int cells) {
  const auto problem = test.problem(cells);
  Rung rung{cells, fem_reference::solve(problem), {}};
  for (const auto& snapshot : rung.history.snapshots) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) {
      const double exact = test.head(problem.mesh.nodes[i], snapshot.time);
      const double head = snapshot.node_pressure[i] / problem.unit_weight;
      difference += (head - exact) * (head - exact);
      size += exact * exact;
    }
    rung.error.push_back(std::sqrt(difference / size));
  }
  return rung;
}

double worst(const std::vector<double>& errors) {
  return *std::max_element(errors.begin(), errors.end());
}

/// A finding against an exact solution: nothing is uncertain but the number itself.
reports::Finding finding(const std::string& quantity, const std::string& description, double error, double tolerance,
                         const std::string& reason) {
  reports::Finding out;
  out.quantity = quantity;
  out.description = description;
  out.error = error;
  out.tolerance = tolerance;
  out.reason = reason;
  out.verdict = verdict(error, 0, tolerance);
  return out;
}

void judge_errors(reports::Record& record, const ClosedFormCase& test, const Rung& rung) {
  for (std::size_t t = 0; t < rung.error.size(); ++t) {
    const double time = rung.history.snapshots[t].time;
    auto out =
        finding("head_l2", fmt::format("relative L2 of the head on {} cells after {:.5g} h", rung.cells, time / 3600),
                rung.error[t], test.gate.relative_l2, test.gate.reason);
    if (time < test.gate.from) out.verdict = reports::Verdict::info;
    out.cpu_s = rung.history.cpu_seconds;
    record.findings.push_back(out);
  }
}

/// The order lies within [low, high] when it is within half the width of the middle.
void judge_order(reports::Record& record, const ClosedFormCase& test, const Rung& coarse, const Rung& fine) {
  const double order = std::log2(worst(coarse.error) / worst(fine.error));
  const double middle = 0.5 * (test.lowest_order + test.highest_order);
  auto out = finding("order_in_space",
                     fmt::format("observed order between {} and {} cells: {:.3f}", coarse.cells, fine.cells, order),
                     std::abs(order - middle), 0.5 * (test.highest_order - test.lowest_order), test.order_reason);
  out.unit = "orders";
  out.explanation = fmt::format("distance from {:g}", middle);
  record.findings.push_back(out);
}

reports::Figure error_over_cells(const std::vector<Rung>& ladder) {
  reports::Figure figure = figure_frame(
      {"error_over_cells", "Worst relative L2 error over the number of cells per direction", "Convergence"},
      {"cells", "-"}, {"relative L2 error", "-"});
  figure.log_x = figure.log_y = true;
  reports::Series measured, second{"second order", reports::Series::Style::dashed, {}, {}, -1};
  measured.label = "reference, linear elements";
  for (const Rung& rung : ladder) {
    measured.x.push_back(rung.cells);
    measured.y.push_back(worst(rung.error));
    second.x.push_back(rung.cells);
    second.y.push_back(worst(ladder.front().error) * std::pow(double(ladder.front().cells) / rung.cells, 2));
  }
  figure.series = {measured, second};
  return figure;
}

/// Heads over elevation on the coarsest rung's vertical line of nodes nearest the middle.
reports::Figure profiles(const ClosedFormCase& test, const Rung& rung) {
  reports::Figure figure =
      figure_frame({"profiles", fmt::format("Pressure head over elevation, {} cells", rung.cells), "Profiles"},
                   {"pressure head", "m"}, {"elevation", "m"});
  const meshes::Mesh& mesh = rung.history.mesh;
  const int up = meshes::up_axis(mesh.dim);
  double widest = 0;
  for (const auto& node : mesh.nodes) widest = std::max(widest, up == 0 ? 0 : node[0]);
  const double unit_weight = test.problem(rung.cells).unit_weight;
  int colour = 0;
  for (const auto& snapshot : rung.history.snapshots) {
    reports::Series exact, points;
    const std::string at = fmt::format("{:.5g} h", snapshot.time / 3600);
    exact.label = "closed form, " + at;
    points.label = "reference, " + at;
    points.style = reports::Series::Style::points;
    exact.colour = points.colour = colour++;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
      if (up != 0 && std::abs(mesh.nodes[i][0] - 0.5 * widest) > 1e-6 * widest) continue;
      exact.x.push_back(test.head(mesh.nodes[i], snapshot.time));
      points.x.push_back(snapshot.node_pressure[i] / unit_weight);
      exact.y.push_back(mesh.nodes[i][up]);
      points.y.push_back(mesh.nodes[i][up]);
    }
    figure.series.push_back(exact);
    figure.series.push_back(points);
  }
  return figure;
}

}  // namespace

reports::Record run_closed_form(const ClosedFormCase& test) {
  reports::Record record;
  record.case_name = test.name;
  record.title = test.title;
  record.requirement = test.requirement + " Source: " + test.source;
  std::vector<Rung> ladder;
  for (const int cells : test.ladder) ladder.push_back(climb(test, cells));
  double imbalance_worst = 0;
  for (const Rung& rung : ladder) {
    record.cpu_seconds += rung.history.cpu_seconds;
    imbalance_worst = std::max(imbalance_worst, imbalance(rung.history.ledger, {rung.history.ledger.back().time}));
    if (rung.cells == test.gate.cells) judge_errors(record, test, rung);
  }
  judge_order(record, test, ladder[ladder.size() - 2], ladder.back());
  record.findings.push_back(finding("water_balance", "water balance on every mesh", imbalance_worst, 1e-7,
                                    "the mixed form conserves water to the Newton tolerance, at any step"));
  record.verdict = overall(record.findings);
  record.figures = {profiles(test, ladder.front()), error_over_cells(ladder)};
  for (const Rung& rung : ladder)
    record.tables.push_back(cost_table(fmt::format("reference on {} cells", rung.cells), rung.history));
  record.provenance = provenance(test.name, ladder.back().history.mesh);
  return record;
}

}  // namespace wetfront::verification
