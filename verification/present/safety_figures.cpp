#include "verification/present/safety_figures.h"

#include "verification/present/figure_frame.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

using reports::Series;

constexpr const char* section = "Safety";

/// The middle of the bracket; what stood last where nothing failed.
double factor(const mpm::SafetyFactor& found) {
  return found.fails > 0 ? 0.5 * (found.stands + found.fails) : found.stands;
}

/// When a curve first falls through one, by a straight line between its points; NaN: never.
double falls_below_one(const Series& curve) {
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (curve.y[k] >= 1) continue;
    if (k == 0) return curve.x[0];
    return curve.x[k - 1] + (curve.x[k] - curve.x[k - 1]) * (curve.y[k - 1] - 1) / (curve.y[k - 1] - curve.y[k]);
  }
  return std::nan("");
}

std::string crossing(const Series& curve) {
  const double time = falls_below_one(curve);
  return curve.label + (std::isnan(time) ? " stays above one" : fmt::format(" falls below one at {:.5g} s", time));
}

std::string bracket(const mpm::SafetyFactor& found) {
  if (found.fails == 0) return fmt::format("> {:.4g}", found.stands);
  return fmt::format("{:.4g} to {:.4g}", found.stands, found.fails);
}

void put(Series& series, double time, double value) {
  series.x.push_back(time);
  series.y.push_back(value);
}

}  // namespace

std::vector<reports::Figure> safety_figures(const std::vector<SafetyRow>& rows) {
  if (rows.empty()) return {};
  Series reduction{"strength reduction", Series::Style::line, {}, {}};
  Series reduced{"infinite slope, strength reduction", Series::Style::dashed, {}, {}};
  Series limit{"infinite slope, tan phi'", Series::Style::dashed, {}, {}};
  Series davis{"infinite slope, Davis' strength", Series::Style::dashed, {}, {}};
  constexpr int grey = 6;
  const Series one{"one", Series::Style::line, {rows.front().time, rows.back().time}, {1, 1}, grey};
  for (const SafetyRow& row : rows) {
    put(reduction, row.time, factor(row.reduction));
    if (!row.slope) continue;
    put(reduced, row.time, row.slope->reduced);
    put(limit, row.time, row.slope->limit);
    put(davis, row.time, row.slope->davis);
  }
  reports::Figure figure = figure_frame({"factor_of_safety", "Factor of safety over time", section}, {"time", "s"},
                                        {"factor of safety", "-"});
  for (const Series* series : {&reduction, &reduced, &limit, &davis}) {
    if (series->x.empty()) continue;
    figure.note += (figure.note.empty() ? "" : "; ") + crossing(*series);
    figure.series.push_back(*series);
  }
  figure.series.push_back(one);
  return {figure};
}

reports::Table safety_table(const std::vector<SafetyRow>& rows) {
  reports::Table table{
      "Factors of safety",
      section,
      "Strength reduction: c', tan phi' and tan psi over F, pore pressures held, until the body fails "
      "by the criterion of its stage. Infinite slope: least over depth, from the same pressures.",
      {"time [s]", "strength reduction", "trials (out of iterations)", "CPU [s]", "infinite slope, tan phi'",
       "at depth [m]", "Davis' strength", "at depth [m]", "as strength reduction"},
      {}};
  for (const SafetyRow& row : rows) {
    std::vector<std::string> cells = {fmt::format("{:.6g}", row.time), bracket(row.reduction),
                                      fmt::format("{} ({})", row.reduction.trials, row.reduction.stalled),
                                      fmt::format("{:.3g}", row.reduction.cpu_seconds)};
    if (const auto& slope = row.slope)
      for (const double value : {slope->limit, slope->limit_depth, slope->davis, slope->davis_depth, slope->reduced})
        cells.push_back(fmt::format("{:.4g}", value));
    cells.resize(table.header.size(), "-");
    table.rows.push_back(std::move(cells));
  }
  if (!rows.empty() && rows.front().slope)
    table.caption += fmt::format(" It stands at x = {:.4g} m, {:.3g} degrees.", rows.front().slope->place,
                                 rows.front().slope->angle * 180 / std::numbers::pi);
  return table;
}

}  // namespace wetfront::verification
