#include "verification/present/motion_balance.h"

#include "verification/compare/magnitude.h"
#include "verification/compare/measure_motion.h"
#include "verification/present/figure_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

using meshes::MotionRow;
using reports::Figure;
using reports::Table;

const MotionRow& row_at(const meshes::FieldHistory& history, double time) {
  const auto after =
      std::ranges::lower_bound(history.motion, time * (1 - 1e-12), {}, [](const MotionRow& row) { return row.time; });
  return after == history.motion.end() ? history.motion.back() : *after;
}

}  // namespace

Table motion_table(const meshes::FieldHistory& history, const Timeline& timeline) {
  Table table;
  table.title = "Energy and momentum of the skeleton";
  table.section = "Energy and momentum";
  table.header = {"time [s]",       "kinetic [J]", "potential, change [J]", "stress work [J]", "work of loads [J]",
                  "resistance [J]", "drift [J]",   "drift, share [%]",      "momentum [N s]",  "momentum, drift"};
  std::vector<double> times = timeline.comparison_times;
  if (times.empty() || times.back() < history.motion.back().time) times.push_back(history.motion.back().time);
  const double energy = energy_scale(history), momentum = momentum_scale(history);
  for (const double time : times) {
    const MotionRow& row = row_at(history, time);
    const double fallen = row.potential - history.motion.front().potential;
    table.rows.push_back({fmt::format("{:.6g}", row.time), fmt::format("{:.4g}", row.kinetic),
                          fmt::format("{:.4g}", fallen), fmt::format("{:.4g}", row.stress_work),
                          fmt::format("{:.4g}", row.load_work), fmt::format("{:.4g}", row.resistance),
                          fmt::format("{:.3g}", row.drift), fmt::format("{:.2f}", 100 * row.drift / energy),
                          fmt::format("{:.4g}", magnitude(row.momentum)),
                          fmt::format("{:.1e}", magnitude(row.momentum_drift) / momentum)});
  }
  table.caption =
      "Per metre of thickness. Stress work is done on the soil, stored or dissipated; resistance is that of sides, "
      "contact "
      "and damping. Drift of energy is what the balance lacks, its share is of the largest entry: points keep motion "
      "that "
      "nodes do not see, and mapping back loses some. Drift of momentum is of the largest of momentum and impulses: "
      "round-off.";
  return table;
}

std::vector<Figure> motion_figures(const meshes::FieldHistory& history) {
  if (history.motion.size() < 2) return {};
  Figure figure =
      figure_frame({"energy", "Energy of the skeleton", "Energy and momentum"}, {"time", "s"}, {"energy", "J"});
  const double first = history.motion.front().potential;
  const auto add = [&](const char* label, const auto& value) {
    reports::Series series;
    series.label = label;
    for (const MotionRow& row : history.motion) {
      series.x.push_back(row.time);
      series.y.push_back(value(row));
    }
    figure.series.push_back(std::move(series));
  };
  add("kinetic", [](const MotionRow& row) { return row.kinetic; });
  add("potential, change", [first](const MotionRow& row) { return row.potential - first; });
  add("stress work", [](const MotionRow& row) { return row.stress_work; });
  add("resistance of sides, contact, damping", [](const MotionRow& row) { return row.resistance; });
  add("drift", [](const MotionRow& row) { return row.drift; });
  figure.series.back().style = reports::Series::Style::dashed;
  const double share = std::abs(history.motion.back().drift) / energy_scale(history);
  figure.note = fmt::format("drift at the end {:.2g} % of the largest", 100 * share);
  return {figure};
}

}  // namespace wetfront::verification
