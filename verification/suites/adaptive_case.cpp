#include "verification/suites/adaptive_case.h"

#include "verification/present/figure_frame.h"
#include "verification/suites/box_mesh.h"
#include "verification/suites/case_book.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;
constexpr double width = 0.6;
constexpr int coarsest = 8;

/// Meshes from `coarsest` on, halved `levels` times; the smallest of the thresholds is the one that is judged.
struct Ladder {
  int levels;
  std::vector<double> thresholds;
  int finest() const { return coarsest << levels; }
  int yardstick() const { return 2 * finest(); }
};

struct Run {
  meshes::FieldHistory history;
  double dofs = 0;        ///< mean over the steps
  double saturation = 0;  ///< rms error, at the worst output time [-]
  double head = 0;        ///< the same of the head [m]
};

/// The yardstick's node at each place.
class Yardstick {
 public:
  Yardstick(meshes::FieldHistory history, int cells) : history_(std::move(history)), cells_(cells) {
    for (std::size_t i = 0; i < history_.mesh.node_count(); ++i) node_[key(history_.mesh.nodes[i])] = i;
  }

  void measure(Run& run) const {
    for (std::size_t t = 0; t < history_.snapshots.size(); ++t) {
      const meshes::Snapshot &mine = run.history.snapshots[t], &fine = history_.snapshots[t];
      double saturation = 0, head = 0;
      for (std::size_t i = 0; i < run.history.mesh.node_count(); ++i) {
        const std::size_t there = node_.at(key(run.history.mesh.nodes[i]));
        saturation += std::pow(mine.node_saturation[i] - fine.node_saturation[there], 2);
        head += std::pow((mine.node_pressure[i] - fine.node_pressure[there]) / 9810, 2);
      }
      const auto count = static_cast<double>(run.history.mesh.node_count());
      run.saturation = std::max(run.saturation, std::sqrt(saturation / count));
      run.head = std::max(run.head, std::sqrt(head / count));
    }
  }

 private:
  std::pair<long, long> key(const meshes::Point& at) const {
    return {std::lround(at[0] / width * cells_), std::lround(at[1] / width * cells_)};
  }
  meshes::FieldHistory history_;
  int cells_;  ///< per direction
  std::map<std::pair<long, long>, std::size_t> node_;
};

/// Every run is recorded on the finest mesh, so that coarse ones answer for what lies between their nodes.
Run run(const std::string& label, int cells, fem::Adaptivity adaptivity, const Yardstick& yardstick, CaseBook& book) {
  fem::RichardsProblem problem = strip_infiltration(cells);
  problem.adaptivity = adaptivity;
  Run result;
  result.history = book.solve(label, problem);
  result.dofs = result.history.counters.at("degrees of freedom, mean over steps");
  yardstick.measure(result);
  return result;
}

std::vector<std::string> row(const std::string& label, const Run& run) {
  const auto& counters = run.history.counters;
  return {label,
          fmt::format("{:.0f}", run.dofs),
          fmt::format("{:.0f}", counters.at("degrees of freedom")),
          fmt::format("{:.0f}", counters.at("adapts")),
          fmt::format("{:.0f}", counters.at("steps")),
          fmt::format("{:.2f}", run.history.cpu_seconds),
          fmt::format("{:.2e}", run.saturation),
          fmt::format("{:.2e}", run.head),
          fmt::format("{:.1e}", relative_imbalance(run.history))};
}

void compare(CaseBook& book, const Ladder& ladder) {
  const int fine_cells = ladder.yardstick();
  const Yardstick yardstick(book.solve(fmt::format("yardstick, {0} x {0}", fine_cells), strip_infiltration(fine_cells)),
                            fine_cells);
  reports::Table table{"Uniform and adaptive meshes",
                       "Cost",
                       "Errors against the yardstick, rms over the nodes of the finest mesh, at the worst output time.",
                       {"mesh", "DoF, mean over steps", "DoF, most", "adapts", "steps", "CPU [s]", "error of S [-]",
                        "error of the head [m]", "water imbalance"},
                       {}};
  auto figure = figure_frame({"error_over_dofs", "Error over degrees of freedom (mean over the steps)", "Cost"},
                             {"degrees of freedom", "-"}, {"rms error of saturation", "-"});
  figure.log_x = figure.log_y = true;
  reports::Series uniform = line("uniform meshes"), adaptive = line("meshes that follow the front");
  constexpr double never = 1;  // no water content changes by that much
  Run fine, best;
  for (int halvings = 0; halvings <= ladder.levels; ++halvings) {
    const std::string label = fmt::format("uniform, {0} x {0}", coarsest << halvings);
    fine = run(label, coarsest << halvings, {ladder.levels - halvings, never}, yardstick, book);
    table.rows.push_back(row(label, fine));
    put(uniform, fine.dofs, fine.saturation);
  }
  for (const double threshold : ladder.thresholds) {
    const std::string label =
        fmt::format("adaptive, {0} x {0} halved up to {1} times, {2:g}", coarsest, ladder.levels, threshold);
    best = run(label, coarsest, {ladder.levels, threshold}, yardstick, book);
    table.rows.push_back(row(label, best));
    put(adaptive, best.dofs, best.saturation);
  }
  figure.series = {uniform, adaptive};
  book.tabulate(table);
  book.draw(figure);
  const Gate error{0.2, "1", "as good as the uniform fine mesh; a fifth is what the yardstick itself may be off"};
  book.judge("error_of_saturation",
             "error of saturation at the smallest threshold beyond that of the uniform finest mesh",
             std::max(0.0, best.saturation / fine.saturation - 1), error);
  book.judge("error_of_head", "error of the head at the smallest threshold beyond that of the uniform finest mesh",
             std::max(0.0, best.head / fine.head - 1), error);
  book.judge("degrees_of_freedom", "degrees of freedom, mean over the steps, over those of the uniform finest mesh",
             best.dofs / fine.dofs, {0.25, "1", "a mesh that follows a front must pay: at most a quarter"});
  book.show("cpu_ratio", "CPU seconds of the uniform finest mesh over those at the smallest threshold",
            fine.history.cpu_seconds / best.history.cpu_seconds, "-");
}

}  // namespace

fem::RichardsProblem strip_infiltration(int cells) {
  fem::RichardsProblem problem;
  problem.mesh = rectangle_mesh(width, width, cells, cells);
  split_side(problem.mesh, "top", "strip", [](const meshes::Point& at) { return at[0] < width / 4; });
  problem.gravity_direction = {0, -1, 0};
  problem.soils = {van_genuchten_soil({0.102, 0.368, 3.35, 2.0, 9.22e-5})};
  problem.boundary = {fem::HeadSide{"strip", -0.75}};
  problem.initial_head.assign(problem.mesh.node_count(), -10.0);
  problem.output_times = {1.5 * hour, 3 * hour, 6 * hour};
  problem.end_time = 6 * hour;
  problem.tolerance = 1e-5;
  return problem;
}

std::vector<Case> adaptive_cases() {
  const std::string requirement =
      "A mesh that follows the front is as accurate as the uniform mesh of its smallest cells, at a fraction of the "
      "cost.";
  const std::string source = "Soil and heads of Celia, Bouloutas & Zarba 1990 (New Mexico), in two dimensions.";
  const Ladder coarse{2, {3e-2, 1e-2, 3e-3}}, fine{3, {3e-2, 1e-2, 3e-3, 1e-3}};
  return {{"adaptive_strip_coarse", "What adaptivity buys: a strip wets dry soil, up to 32 x 32", requirement, source,
           Effort::everyday, [coarse](CaseBook& book) { compare(book, coarse); }},
          {"adaptive_strip", "What adaptivity buys: a strip wets dry soil, up to 64 x 64", requirement, source,
           Effort::heavy, [fine](CaseBook& book) { compare(book, fine); }}};
}

}  // namespace wetfront::verification
