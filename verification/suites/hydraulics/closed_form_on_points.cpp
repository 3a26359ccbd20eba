#include "verification/suites/hydraulics/closed_form_on_points.h"

#include "meshes/evaluate.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/on_points.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace wetfront::verification {
namespace {

struct Run {
  int cells, points;
  meshes::FieldHistory history;
  std::vector<double> error;  ///< one per output time
  double worst() const { return *std::max_element(error.begin(), error.end()); }
};

Run solve(const OnPoints& test, int cells, int points, CaseBook& book) {
  const auto reference = test.exact.problem(cells);
  mpm::Problem<2> problem = on_points(reference);
  problem.points_per_cell = points;
  problem.stages[0].time_tolerance = test.time_tolerance;
  Run run{cells, points, book.solve(fmt::format("{} cells, {} points each", cells, points), problem), {}};
  run.error = head_errors(run.history, test.exact, reference.mesh.dim == 1);
  return run;
}

std::string time_text(double seconds) {
  return seconds < 600 ? fmt::format("{:.4g} s", seconds) : fmt::format("{:.4g} h", seconds / 3600);
}

reports::Figure profiles(const OnPoints& test, const Run& run) {
  auto figure = figure_frame({"profiles", fmt::format("Pressure head over elevation, {} cells", run.cells), "Profiles"},
                             {"pressure head", "m"}, {"elevation", "m"});
  const meshes::Mesh& mesh = run.history.mesh;
  const bool on_axis = test.exact.problem(test.ladder.front()).mesh.dim == 1;
  const std::string yardstick = test.reference_cells > 0 ? "reference, " : "closed form, ";
  int colour = 0;
  for (const auto& snapshot : run.history.snapshots) {
    auto exact = line(yardstick + time_text(snapshot.time), colour);
    auto ours = points("seepage, " + time_text(snapshot.time), colour++);
    const auto heads = heads_of(snapshot);
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
      if (mesh.nodes[i][0] != 0) continue;  // the left line of nodes
      const meshes::Point at = on_axis ? meshes::Point{mesh.nodes[i][1]} : mesh.nodes[i];
      put(exact, test.exact.head(at, snapshot.time), mesh.nodes[i][1]);
      put(ours, heads[i], mesh.nodes[i][1]);
    }
    figure.series.push_back(exact);
    figure.series.push_back(ours);
  }
  return figure;
}

reports::Figure error_over_cells(const std::vector<Run>& ladder) {
  auto figure = figure_frame({"error_over_cells", "Worst relative L2 error over the number of cells", "Convergence"},
                             {"cells", "-"}, {"relative L2 error", "-"});
  figure.log_x = figure.log_y = true;
  auto measured = line("seepage, 4 points per cell"), second = dashed("second order");
  for (const Run& run : ladder) {
    put(measured, run.cells, run.worst());
    put(second, run.cells, ladder.front().worst() * std::pow(double(ladder.front().cells) / run.cells, 2));
  }
  figure.series = {measured, second};
  return figure;
}

/// Points per cell do not change what a rule exact for linear fields already integrates; one point does in two
/// dimensions.
void vary_points(const OnPoints& test, const Run& four, CaseBook& book) {
  reports::Table table{"Error over points per cell",
                       "Convergence",
                       fmt::format("{} cells.", four.cells),
                       {"points per cell", "worst relative L2", "CPU [s]"},
                       {}};
  const auto row = [&](const Run& run) {
    table.rows.push_back({fmt::format("{}", run.points), fmt::format("{:.3e}", run.worst()),
                          fmt::format("{:.3f}", run.history.cpu_seconds)});
  };
  row(four);
  for (const int points : test.points_per_cell) {
    const Run run = solve(test, four.cells, points, book);
    row(run);
    if (points > 4)
      book.judge("points", fmt::format("error with {} points per cell over that with 4, less 1", points),
                 std::abs(run.worst() / four.worst() - 1),
                 {test.change_with_points, "1",
                  "both rules integrate linear fields exactly; what differs is the curvature of K in a cell"});
  }
  book.tabulate(table);
}

void climb(const OnPoints& test, CaseBook& book) {
  std::vector<Run> ladder;
  for (const int cells : test.ladder) ladder.push_back(solve(test, cells, 4, book));
  for (const Run& run : ladder) {
    if (run.cells != test.gate.cells) continue;
    for (std::size_t t = 0; t < run.error.size(); ++t)
      book.judge("error",
                 fmt::format("relative L2 of the head over the nodes, {} cells, after {}", run.cells,
                             time_text(run.history.snapshots[t].time)),
                 run.error[t], {test.gate.relative_l2, "1", test.gate.reason});
  }
  vary_points(test, ladder.front(), book);
  const Run &coarse = ladder[ladder.size() - 2], &fine = ladder.back();
  book.judge_order("order", fmt::format("observed order between {} and {} cells", coarse.cells, fine.cells),
                   std::log2(coarse.worst() / fine.worst()), test.order);
  book.draw(profiles(test, ladder.front()));
  book.draw(error_over_cells(ladder));
}

/// Heads of the reference's run anywhere, at its output times.
std::function<double(const meshes::Point&, double)> heads_of_run(meshes::FieldHistory history) {
  const auto kept = std::make_shared<const meshes::FieldHistory>(std::move(history));
  const auto evaluate = std::make_shared<const meshes::Evaluator>(kept->mesh);
  return [kept, evaluate](const meshes::Point& at, double time) {
    const auto snapshot = std::ranges::min_element(
        kept->snapshots, {}, [time](const meshes::Snapshot& s) { return std::abs(s.time - time); });
    return (*evaluate)(snapshot->node_pressure, at) / 9810;
  };
}

void run_case(OnPoints test, CaseBook& book) {
  if (!test.exact.head) {
    auto problem = test.exact.problem(test.reference_cells);
    problem.tolerance = test.reference_tolerance;
    test.exact.head = heads_of_run(book.solve(fmt::format("reference, {} cells", test.reference_cells), problem));
  }
  climb(test, book);
}

}  // namespace

std::vector<double> head_errors(const meshes::FieldHistory& history, const ClosedFormCase& exact, bool line) {
  std::vector<double> errors;
  for (const auto& snapshot : history.snapshots) {
    std::vector<double> expected;
    for (const auto& node : history.mesh.nodes)
      expected.push_back(exact.head(line ? meshes::Point{node[1]} : node, snapshot.time));
    errors.push_back(relative_l2(heads_of(snapshot), expected));
  }
  return errors;
}

Case as_case(const OnPoints& test) {
  return {test.exact.name,   test.exact.title, test.exact.requirement,
          test.exact.source, test.effort,      [test](CaseBook& book) { run_case(test, book); }};
}

}  // namespace wetfront::verification
