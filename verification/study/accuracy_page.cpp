// What accuracy costs, as a page.
#include "verification/compare/gates.h"
#include "verification/present/figure_frame.h"
#include "verification/scene/quantities.h"
#include "verification/scene/read.h"
#include "verification/study/accuracy.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

/// Quantities that are errors of the discretisation: balances are not.
constexpr const char* studied[] = {"pressure_l2",  "saturation_l2", "front_position", "cumulative_infiltration",
                                   "ponding_time", "arrival_time",  "rise_rate"};

bool in_metres(const std::string& quantity) {
  return find_quantity(quantity)->unit == "m";
}

std::string percent_or_metres(double value, const std::string& quantity) {
  if (std::isnan(value)) return "-";
  return in_metres(quantity) ? fmt::format("{:.3g} mm", 1e3 * value) : fmt::format("{:.3g} %", 100 * value);
}

struct Study {
  const std::vector<AccuracyPoint>& points;
  const std::vector<PointResult>& results;
};

Figure work_precision(const Study& study, const std::string& quantity, const std::vector<ReferenceCost>& reference) {
  const bool metres = in_metres(quantity);
  Figure figure = figure_frame({"work_" + quantity, "Error over CPU seconds: " + quantity, "Cost"},
                               {"CPU of the MPM", "s"}, {"largest error", metres ? "m" : "1"});
  figure.log_x = figure.log_y = true;
  std::vector<std::string> names;
  std::map<std::string, Series> curves;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const double error = error_of(study.results[i], quantity);
    if (!(error > 0) || !std::isfinite(error) || !(study.results[i].candidate_cpu > 0)) continue;
    const std::string& name = study.points[i].curve;
    if (!curves.contains(name)) {
      names.push_back(name);
      curves[name] = {name, Series::Style::points, {}, {}, static_cast<int>(names.size()) - 1};
    }
    curves[name].x.push_back(study.results[i].candidate_cpu);
    curves[name].y.push_back(error);
  }
  for (const std::string& name : names) figure.series.push_back(curves[name]);
  Series front{"Pareto front", Series::Style::dashed, {}, {}, static_cast<int>(names.size())};
  for (const std::size_t i : pareto(study.results, quantity)) {
    if (!(error_of(study.results[i], quantity) > 0)) continue;
    front.x.push_back(study.results[i].candidate_cpu);
    front.y.push_back(error_of(study.results[i], quantity));
  }
  figure.series.push_back(std::move(front));
  if (quantity == "pressure_l2" && !reference.empty()) {
    Series line{"reference, at its nodes", Series::Style::line, {}, {}, static_cast<int>(names.size()) + 1};
    for (const ReferenceCost& cost : reference)
      if (cost.error > 0) line.x.push_back(cost.cpu_seconds), line.y.push_back(cost.error);
    figure.series.push_back(std::move(line));
  }
  return figure;
}

reports::Table points_table(const Study& study, const std::filesystem::path& out) {
  reports::Table table{"Settings",
                       "Settings",
                       "Pareto: no other setting has both a smaller error of pressure and a lower cost.",
                       {"setting", "verdict", "MPM CPU [s]"},
                       {}};
  for (const char* quantity : studied) table.header.push_back(quantity);
  table.header.push_back("Pareto");
  table.header.push_back("remark");
  const auto front = pareto(study.results, "pressure_l2");
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const PointResult& result = study.results[i];
    std::vector<std::string> row{study.points[i].point.name};
    if (result.left_out()) {
      row.insert(row.end(), {"not run", fmt::format("about {:.3g}", result.expected_cpu)});
      row.insert(row.end(), std::size(studied) + 1, "");
      row.push_back("its plan expects more than the study may spend on a point");
    } else {
      row.insert(row.end(), {verdict_of(result), fmt::format("{:.3g}", result.candidate_cpu)});
      for (const char* quantity : studied) row.push_back(percent_or_metres(error_of(result, quantity), quantity));
      row.push_back(std::ranges::find(front, i) != front.end() ? "yes" : "");
      row.push_back(result.message);
    }
    table.rows.push_back(std::move(row));
    table.links.push_back(result.left_out() ? "" : link_to(out, i, study.points[i].point));
  }
  return table;
}

/// Observed orders in the cell size, scheme by scheme, and where halving the cells stops to help.
reports::Table orders_table(const Study& study) {
  reports::Table table{
      "Order in the cell size, and floors",
      "Orders",
      "Error of pressure (relative L2, worst time). Spatial floor: what the scene's cells leave when the "
      "time integration is made exact. Temporal floor: where halving the cells helps no more.",
      {"scheme", "errors, from coarse to fine cells", "orders between them", "class",
       "spatial floor at the scene's cells", "temporal floor"},
      {}};
  std::vector<std::string> curves;
  for (const AccuracyPoint& point : study.points)
    if (point.point.settings.size() && std::ranges::find(curves, point.curve) == curves.end())
      curves.push_back(point.curve);
  double exact_in_time = std::nan("");
  for (std::size_t i = 0; i < study.points.size(); ++i)
    if (study.points[i].curve == "time tolerance")
      exact_in_time = error_of(study.results[i], "pressure_l2");  // the tightest is last
  for (const std::string& curve : curves) {
    struct Told {
      double cells, error;
    };
    std::vector<Told> told;  // points may be missing: what lies between two is told by their cells
    for (std::size_t i = 0; i < study.points.size(); ++i)
      if (study.points[i].curve == curve && std::isfinite(error_of(study.results[i], "pressure_l2")))
        told.push_back({study.points[i].cells, error_of(study.results[i], "pressure_l2")});
    if (told.size() < 2 || curve == "time tolerance" || curve == "points per cell" || curve == "shape functions")
      continue;
    std::string shown, orders;
    bool falls = true, floor = false;
    for (std::size_t i = 0; i < told.size(); ++i) {
      shown += (i ? ", " : "") + percent_or_metres(told[i].error, "pressure_l2");
      if (i == 0) continue;
      const double order = std::log(told[i - 1].error / told[i].error) / std::log(told[i].cells / told[i - 1].cells);
      orders += (i > 1 ? ", " : "") + fmt::format("{:.2f}", order);
      falls = falls && order > 0;
      floor = order < 0.5;
    }
    table.rows.push_back({curve, shown, orders,
                          !falls  ? "not monotone"
                          : floor ? "monotone, then a floor"
                                  : "monotone",
                          curve.starts_with("seepage, bdf2") ? percent_or_metres(exact_in_time, "pressure_l2") : "-",
                          floor ? percent_or_metres(std::ranges::min(told, {}, &Told::error).error, "pressure_l2")
                                : "below " + percent_or_metres(told.back().error, "pressure_l2")});
  }
  return table;
}

reports::Table cheapest_table(const Study& study, const Scene& scene) {
  reports::Table table{"The cheapest setting that meets each gate of the scene",
                       "Verdicts",
                       "The error with the reference's own doubt must be within the gate.",
                       {"quantity", "gate", "cheapest setting", "its error", "MPM CPU [s]"},
                       {}};
  for (const char* quantity : studied) {
    const auto gate = narrowest_gate(scene, quantity);
    if (!gate) continue;
    const auto best = cheapest(study.results, quantity, *gate);
    table.rows.push_back({quantity, percent_or_metres(*gate, quantity),
                          best ? study.results[*best].name : "none of these",
                          best ? percent_or_metres(error_of(study.results[*best], quantity), quantity) : "-",
                          best ? fmt::format("{:.3g}", study.results[*best].candidate_cpu) : "-"});
  }
  return table;
}

}  // namespace

reports::Record accuracy_page(const std::filesystem::path& path, const std::vector<AccuracyPoint>& points,
                              const std::vector<PointResult>& results, const std::vector<ReferenceCost>& reference,
                              const std::filesystem::path& out) {
  reports::Record record = start_study("what accuracy costs", path, results);
  record.verdict = reports::Verdict::info;  // coarse settings are meant to miss
  const Study study{points, results};
  record.tables.push_back(cheapest_table(study, read_scene(path)));
  record.tables.push_back(orders_table(study));
  for (const char* quantity : studied) {
    Figure figure = work_precision(study, quantity, reference);
    if (!figure.series.front().x.empty()) record.figures.push_back(std::move(figure));
  }
  if (!reference.empty()) {
    reports::Table table{"The reference",
                         "Cost",
                         "Error of pressure at its nodes against cells half as large as the finest here.",
                         {"cells", "error", "CPU [s]"},
                         {}};
    for (const ReferenceCost& cost : reference)
      table.rows.push_back({std::to_string(cost.cells), percent_or_metres(cost.error, "pressure_l2"),
                            fmt::format("{:.3g}", cost.cpu_seconds)});
    record.tables.push_back(std::move(table));
  }
  record.tables.push_back(points_table(study, out));
  return record;
}

}  // namespace wetfront::verification
