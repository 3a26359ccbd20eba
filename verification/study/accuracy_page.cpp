// What accuracy costs, as a page.
#include "reports/palette.h"
#include "verification/compare/gates.h"
#include "verification/present/figure_frame.h"
#include "verification/scene/quantities.h"
#include "verification/study/accuracy.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

/// Quantities that are errors of the discretisation: balances are not.
struct Studied {
  const char *quantity, *name;
};
constexpr Studied studied[] = {{"pressure_l2", "pore pressure (relative L2)"},
                               {"saturation_l2", "saturation (relative L2)"},
                               {"front_position", "wetting front"},
                               {"cumulative_infiltration", "water taken in"},
                               {"ponding_time", "time of ponding"},
                               {"arrival_time", "arrival at the probes"},
                               {"rise_rate", "rate of rise at the probes"}};

/// Below it an error is round-off, and a figure of it says nothing.
constexpr double round_off = 1e-9;

bool in_metres(const std::string& quantity) {
  return find_quantity(quantity)->unit == "m";
}

std::string percent_or_metres(double value, const std::string& quantity) {
  if (!std::isfinite(value)) return "-";  // not measured, or it did not happen in one of the two
  if (std::abs(value) < round_off) return "round-off";
  return in_metres(quantity) ? fmt::format("{:.3g} mm", 1e3 * value) : fmt::format("{:.3g} %", 100 * value);
}

struct Study {
  std::vector<AccuracyPoint> points;
  std::vector<PointResult> results;
  std::vector<std::size_t> number;  ///< of each point in the whole study
};

/// The points of one window; of the whole scene: "".
Study part_of(const std::vector<AccuracyPoint>& points, const std::vector<PointResult>& results,
              const std::string& window) {
  Study part;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].window == window) {
      part.points.push_back(points[i]);
      part.results.push_back(results[i]);
      part.number.push_back(i);
    }
  return part;
}

std::vector<std::string> windows_of(const std::vector<AccuracyPoint>& points) {
  std::vector<std::string> windows;
  for (const AccuracyPoint& point : points)
    if (!point.window.empty() && std::ranges::find(windows, point.window) == windows.end())
      windows.push_back(point.window);
  return windows;
}

/// One curve per scheme, by cells or by what else was changed.
Figure work_precision(const Study& study, const FigureHeading& heading, const FigureAxis& error_axis,
                      const std::vector<double>& errors) {
  Figure figure = figure_frame(heading, {"CPU of the MPM", "s"}, error_axis);
  figure.log_x = figure.log_y = true;
  std::vector<Series> curves;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const double error = errors[i], cost = study.results[i].candidate_cpu;
    if (!(error > round_off) || !std::isfinite(error) || !(cost > 0)) continue;
    const std::string& name = study.points[i].curve;
    auto curve = std::ranges::find(curves, name, &Series::label);
    if (curve == curves.end())
      curve = curves.insert(curve, {name, Series::Style::points, {}, {}, static_cast<int>(curves.size())});
    curve->x.push_back(cost);
    curve->y.push_back(error);
  }
  if (curves.empty()) return figure;
  for (const Series& curve : curves)  // a line through the points; their legend is enough
    figure.series.push_back({"", Series::Style::line, curve.x, curve.y, curve.colour});
  std::ranges::move(curves, std::back_inserter(figure.series));
  Series front{"Pareto front", Series::Style::dashed, {}, {}, reports::colour_of_the_best};
  for (const std::size_t i : pareto(study.results, errors)) {
    if (!(errors[i] > round_off)) continue;
    front.x.push_back(study.results[i].candidate_cpu);
    front.y.push_back(errors[i]);
  }
  figure.series.push_back(std::move(front));
  return figure;
}

/// Against the reference; with the reference's own curve where it has one.
Figure against_reference(const Study& study, const Studied& about, const std::vector<ReferenceCost>& reference) {
  const std::string quantity = about.quantity, name = about.name;
  Figure figure =
      work_precision(study, {"work_" + quantity, "Error over CPU seconds: " + name, "Error over cost"},
                     {"error of " + name, in_metres(quantity) ? "m" : "1"}, errors_of(study.results, quantity));
  if (figure.series.empty()) return figure;
  if (quantity == "pressure_l2" && !reference.empty()) {
    Series line{"reference, at its nodes", Series::Style::line, {}, {}, reports::colour_of_the_reference};
    for (const ReferenceCost& cost : reference)
      if (cost.error > 0) line.x.push_back(cost.cpu_seconds), line.y.push_back(cost.error);
    figure.series.push_back(std::move(line));
  }
  figure.note = "The largest of all comparison times and probes, against the reference.";
  return figure;
}

/// The same in a window, in which schemes are affordable that are not over the whole scene.
void add_window(reports::Record& record, const Study& study, const std::vector<ReferenceCost>& reference,
                std::size_t index) {
  const std::string& window = study.points.front().window;
  for (const Studied& about : {studied[0], studied[2]}) {
    Figure figure = against_reference(study, about, reference);
    if (figure.series.empty()) continue;
    figure.id += "_window_" + std::to_string(index);
    figure.title += ", a window " + window;
    figure.section = "Windows";
    figure.note =
        "Seepage up to the window on the same cells, then each scheme. The error is that at the window's end, "
        "what seepage brought along and the hand-over included; the seconds are those of both.";
    for (Series& series : figure.series)
      if (series.label.starts_with("reference")) series.label = "reference, whole scene";
    record.figures.push_back(std::move(figure));
  }
}

reports::Table points_table(const Study& study, const std::filesystem::path& out) {
  const std::string& window = study.points.front().window;
  const bool whole = window.empty();
  reports::Table table{whole ? "Settings" : "Settings, a window " + window,
                       "Settings",
                       "Pareto: no other setting has both a smaller error of pressure and a lower cost.",
                       {"setting", "verdict", "MPM CPU [s]"},
                       {}};
  std::vector<Studied> known;  // of a scene without a reference none
  for (const Studied& about : studied)
    if (std::ranges::any_of(study.results,
                            [&](const PointResult& r) { return !std::isnan(error_of(r, about.quantity)); }))
      known.push_back(about);
  for (const Studied& about : known) table.header.push_back(about.name);
  table.header.push_back("Pareto");
  table.header.push_back("remark");
  const auto front = pareto(study.results, "pressure_l2");
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const PointResult& result = study.results[i];
    std::string name = study.points[i].point.name;
    if (!whole) name.resize(name.size() - window.size() - 2);  // its heading says it
    std::vector<std::string> row{name};
    if (result.left_out()) {
      row.insert(row.end(), {"not run", fmt::format("about {:.3g}", result.expected_cpu)});
      row.insert(row.end(), known.size() + 1, "");
      row.push_back("costs more than --budget");
    } else {
      // A window is not what the scene's gates are about.
      row.insert(row.end(),
                 {whole || !result.ran() ? verdict_of(result) : "-", fmt::format("{:.3g}", result.candidate_cpu)});
      for (const Studied& about : known)
        row.push_back(percent_or_metres(error_of(result, about.quantity), about.quantity));
      row.push_back(std::ranges::find(front, i) != front.end() ? "yes" : "");
      row.push_back(result.message);
    }
    table.rows.push_back(std::move(row));
    table.links.push_back(result.left_out() ? "" : link_to(out, study.number[i], study.points[i].point));
  }
  return table;
}

/// Observed orders in the cell size, scheme by scheme, and where halving the cells stops to help.
reports::Table orders_table(const Study& study) {
  const std::string window = study.points.empty() ? "" : study.points.front().window;
  reports::Table table{
      window.empty() ? "Order in the cell size, and floors" : "Order in the cell size, a window " + window,
      "Orders",
      "Class: monotone, every refinement lowers the error; oscillatory, some raise it; divergent, the finest cells are "
      "no "
      "better than the coarsest. Error of pressure (relative L2, worst time). Spatial floor: what the scene's cells "
      "leave when the "
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
    if (told.size() < 2 || told.front().cells == told.back().cells) continue;  // something else was changed
    std::string shown, orders;
    bool floor = false;
    std::vector<double> errors;
    for (std::size_t i = 0; i < told.size(); ++i) {
      errors.push_back(told[i].error);
      shown += (i ? ", " : "") + percent_or_metres(told[i].error, "pressure_l2");
      if (i == 0) continue;
      const double order = std::log(told[i - 1].error / told[i].error) / std::log(told[i].cells / told[i - 1].cells);
      orders += (i > 1 ? ", " : "") + fmt::format("{:.2f}", order);
      floor = order < 0.5;
    }
    const Convergence seen = convergence_of(errors);
    table.rows.push_back({curve, shown, orders,
                          std::string(word(seen)) + (floor && seen == Convergence::monotone ? ", then a floor" : ""),
                          curve.starts_with("seepage, bdf2") ? percent_or_metres(exact_in_time, "pressure_l2") : "-",
                          floor ? percent_or_metres(std::ranges::min(told, {}, &Told::error).error, "pressure_l2")
                                : "below " + percent_or_metres(told.back().error, "pressure_l2")});
  }
  return table;
}

/// What comes out of a slide, which no reference knows: against the run on the finest cells.
void add_slide(reports::Record& record, const Study& study) {
  static constexpr const char* followed[] = {"failure_time", "largest_displacement", "largest_velocity"};
  reports::Table table{
      "What came out of the slide",
      "Error over cost",
      "In brackets: off from the run on the finest cells, whose own doubt is about its step to the next coarser one.",
      {"setting", "MPM CPU [s]"},
      {}};
  std::vector<std::vector<std::string>> columns;
  for (const char* name : followed) {
    const auto finest = finest_with(study.points, study.results, name);
    if (!finest) continue;
    const Outcome about = *find_outcome(study.results[*finest].candidate, name);
    const std::vector<double> errors = changes_from(study.results, *finest, name);
    table.header.push_back(about.description + " [" + about.unit + "]");
    std::vector<std::string>& column = columns.emplace_back();
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double value = value_of(study.results[i].candidate, name);
      column.push_back(std::isnan(value) ? "-"
                       : i == *finest    ? fmt::format("{:.5g} (finest)", value)
                                         : fmt::format("{:.5g} ({:.2g} %)", value, 100 * errors[i]));
    }
    Figure figure = work_precision(
        study, {std::string("work_") + name, "Error over CPU seconds: " + about.description, "Error over cost"},
        {"off from the finest cells", "1"}, errors);
    figure.note = "No reference knows it: against " + study.points[*finest].point.name + ".";
    if (!figure.series.empty()) record.figures.push_back(std::move(figure));
  }
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    if (columns.empty() || !(study.results[i].candidate_cpu > 0)) continue;  // left out, or refused
    std::vector<std::string> row{study.points[i].point.name, fmt::format("{:.3g}", study.results[i].candidate_cpu)};
    for (const auto& column : columns) row.push_back(column[i]);
    table.rows.push_back(std::move(row));
  }
  if (!table.rows.empty()) record.tables.push_back(std::move(table));
}

reports::Table cheapest_table(const Study& study, const Scene& scene) {
  reports::Table table{"The cheapest setting that meets each gate of the scene",
                       "Verdicts",
                       "The error with the reference's own doubt must be within the gate.",
                       {"quantity", "gate", "cheapest setting", "its error", "MPM CPU [s]"},
                       {}};
  for (const auto& [quantity, name] : studied) {
    const auto gate = narrowest_gate(scene, quantity);
    if (!gate) continue;
    const auto best = cheapest(study.results, quantity, *gate);
    table.rows.push_back({name, percent_or_metres(*gate, quantity), best ? study.results[*best].name : "none of these",
                          best ? percent_or_metres(error_of(study.results[*best], quantity), quantity) : "-",
                          best ? fmt::format("{:.3g}", study.results[*best].candidate_cpu) : "-"});
  }
  return table;
}

}  // namespace

reports::Record accuracy_page(const Scene& scene, const std::vector<AccuracyPoint>& points,
                              const std::vector<PointResult>& results, const std::vector<ReferenceCost>& reference,
                              const std::filesystem::path& out) {
  reports::Record record = start_study("what accuracy costs", scene, results);
  record.verdict = reports::Verdict::info;  // coarse settings are meant to miss
  const Study study = part_of(points, results, "");
  for (reports::Table& table : std::vector{cheapest_table(study, scene), orders_table(study)})
    if (!table.rows.empty()) record.tables.push_back(table);
  for (const Studied& about : studied) {
    Figure figure = against_reference(study, about, reference);
    if (!figure.series.empty()) record.figures.push_back(std::move(figure));
  }
  add_slide(record, study);
  const std::vector<std::string> windows = windows_of(points);
  for (std::size_t w = 0; w < windows.size(); ++w) {
    const Study part = part_of(points, results, windows[w]);
    add_window(record, part, reference, w);
    if (reports::Table orders = orders_table(part); !orders.rows.empty()) record.tables.push_back(std::move(orders));
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
  if (!study.points.empty()) record.tables.push_back(points_table(study, out));
  for (const std::string& window : windows)
    record.tables.push_back(points_table(part_of(points, results, window), out));
  return record;
}

}  // namespace wetfront::verification
