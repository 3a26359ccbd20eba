#include "verification/suites/work_precision.h"

#include "verification/present/figure_frame.h"
#include "verification/run/provenance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

struct Sweep {
  std::string label;
  fem::Integrator integrator;
  std::vector<double> tolerances;
};

/// Largest rms difference of the head over the output times [m].
double difference(const meshes::FieldHistory& a, const meshes::FieldHistory& b, double unit_weight) {
  double worst = 0;
  for (std::size_t t = 0; t < b.snapshots.size(); ++t) {
    double squares = 0;
    const auto &p = a.snapshots[t].node_pressure, &q = b.snapshots[t].node_pressure;
    for (std::size_t i = 0; i < q.size(); ++i) squares += std::pow((p[i] - q[i]) / unit_weight, 2);
    worst = std::max(worst, std::sqrt(squares / q.size()));
  }
  return worst;
}

}  // namespace

reports::Record work_precision(const ClosedFormCase& test, int cells) {
  fem::RichardsProblem problem = test.problem(cells);
  problem.tolerance = 1e-9;
  const meshes::FieldHistory yardstick = fem::solve(problem);
  reports::Figure figure =
      figure_frame({"work_precision", fmt::format("Error in time over CPU seconds, {} cells", cells), "Cost"},
                   {"CPU", "s"}, {"rms error of the head", "m"});
  figure.log_x = figure.log_y = true;
  reports::Table table{"Work and precision",
                       "Cost",
                       "Errors against the same mesh at tolerance 1e-9.",
                       {"integrator", "tolerance", "steps", "CPU [s]", "rms error of the head [m]"},
                       {}};
  reports::Record record;
  for (const Sweep& sweep : {Sweep{"BDF", fem::Integrator::bdf, {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
                             Sweep{"backward Euler", fem::Integrator::backward_euler, {1e-2, 1e-3, 1e-4, 1e-5}}}) {
    reports::Series series;
    series.label = sweep.label;
    for (const double tolerance : sweep.tolerances) {
      problem.integrator = sweep.integrator;
      problem.tolerance = tolerance;
      const meshes::FieldHistory history = fem::solve(problem);
      series.x.push_back(history.cpu_seconds);
      series.y.push_back(difference(history, yardstick, problem.unit_weight));
      const auto steps = history.counters.find("steps");
      table.rows.push_back({sweep.label, fmt::format("{:g}", tolerance),
                            steps == history.counters.end() ? "-" : fmt::format("{:g}", steps->second),
                            fmt::format("{:.4f}", history.cpu_seconds), fmt::format("{:.2e}", series.y.back())});
      record.cpu_seconds += history.cpu_seconds;
    }
    figure.series.push_back(series);
  }
  record.case_name = "work_precision_" + test.name;
  record.title = "Work and precision: " + test.title;
  record.requirement = "What accuracy in time costs, BDF beside backward Euler on one mesh.";
  record.figures = {figure};
  record.tables = {table};
  record.provenance = provenance(record.case_name, yardstick.mesh);
  return record;
}

}  // namespace wetfront::verification
