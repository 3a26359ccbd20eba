#include "verification/suites/closed_form_case.h"

#include "verification/present/figure_frame.h"

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

Rung climb(const ClosedFormCase& test, int cells, CaseBook& book) {
  const auto problem = test.problem(cells);
  Rung rung{cells, book.solve(fmt::format("{} cells", cells), problem), {}};
  for (const auto& snapshot : rung.history.snapshots) {
    std::vector<double> exact;
    for (const auto& node : problem.mesh.nodes) exact.push_back(test.head(node, snapshot.time));
    rung.error.push_back(relative_l2(heads_of(snapshot, problem.unit_weight), exact));
  }
  return rung;
}

double worst(const std::vector<double>& errors) {
  return *std::max_element(errors.begin(), errors.end());
}

std::string time_text(double seconds) {
  return seconds < 600 ? fmt::format("{:.4g} s", seconds) : fmt::format("{:.4g} h", seconds / 3600);
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

/// Whether a node lies on the vertical line through the middle of the mesh (the nearest line of nodes right of it).
class MiddleLine {
 public:
  explicit MiddleLine(const meshes::Mesh& mesh) : up_(meshes::up_axis(mesh.dim)) {
    for (int axis = 0; axis < up_; ++axis) {
      double widest = 0;
      for (const auto& node : mesh.nodes) widest = std::max(widest, node[axis]);
      at_[axis] = widest;
      for (const auto& node : mesh.nodes)
        if (node[axis] >= 0.5 * widest * (1 - 1e-9)) at_[axis] = std::min(at_[axis], node[axis]);
    }
  }
  bool holds(const meshes::Point& node) const {
    for (int axis = 0; axis < up_; ++axis)
      if (std::abs(node[axis] - at_[axis]) > 1e-6 * at_[axis]) return false;
    return true;
  }

 private:
  int up_;
  meshes::Point at_{};
};

reports::Figure profiles(const ClosedFormCase& test, const Rung& rung) {
  reports::Figure figure =
      figure_frame({"profiles", fmt::format("Pressure head over elevation, {} cells", rung.cells), "Profiles"},
                   {"pressure head", "m"}, {"elevation", "m"});
  const meshes::Mesh& mesh = rung.history.mesh;
  const int up = meshes::up_axis(mesh.dim);
  const MiddleLine line(mesh);
  int colour = 0;
  for (const auto& snapshot : rung.history.snapshots) {
    const std::vector<double> heads = heads_of(snapshot);
    reports::Series exact, points;
    exact.label = "closed form, " + time_text(snapshot.time);
    points.label = "reference, " + time_text(snapshot.time);
    points.style = reports::Series::Style::points;
    exact.colour = points.colour = colour++;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
      if (!line.holds(mesh.nodes[i])) continue;
      exact.x.push_back(test.head(mesh.nodes[i], snapshot.time));
      points.x.push_back(heads[i]);
      exact.y.push_back(mesh.nodes[i][up]);
      points.y.push_back(mesh.nodes[i][up]);
    }
    figure.series.push_back(exact);
    figure.series.push_back(points);
  }
  return figure;
}

void climb_and_judge(const ClosedFormCase& test, CaseBook& book) {
  std::vector<Rung> ladder;
  for (const int cells : test.ladder) ladder.push_back(climb(test, cells, book));
  for (const Rung& rung : ladder)
    for (std::size_t t = 0; t < rung.error.size() && rung.cells == test.gate.cells; ++t)
      book.judge("error",
                 fmt::format("relative L2 of the head over the nodes, {} cells, after {}", rung.cells,
                             time_text(rung.history.snapshots[t].time)),
                 rung.error[t], {test.gate.relative_l2, "1", test.gate.reason});
  const Rung &coarse = ladder[ladder.size() - 2], &fine = ladder.back();
  book.judge_order("order", fmt::format("observed order between {} and {} cells", coarse.cells, fine.cells),
                   std::log2(worst(coarse.error) / worst(fine.error)), test.order);
  book.draw(profiles(test, ladder.front()));
  book.draw(error_over_cells(ladder));
}

}  // namespace

double relative_l2(const std::vector<double>& heads, const std::vector<double>& exact) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    difference += (heads[i] - exact[i]) * (heads[i] - exact[i]);
    size += exact[i] * exact[i];
  }
  return std::sqrt(difference / size);
}

std::vector<double> heads_of(const meshes::Snapshot& snapshot, double unit_weight) {
  std::vector<double> heads = snapshot.node_pressure;
  for (double& head : heads) head /= unit_weight;
  return heads;
}

Case as_case(const ClosedFormCase& test) {
  return {test.name,   test.title,  test.requirement,
          test.source, test.effort, [test](CaseBook& book) { climb_and_judge(test, book); }};
}

}  // namespace wetfront::verification
