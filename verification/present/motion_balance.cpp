#include "verification/present/motion_balance.h"

#include "verification/compare/magnitude.h"
#include "verification/compare/measure_motion.h"
#include "verification/present/figure_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace wetfront::verification {
namespace {

using meshes::MotionRow;
using reports::Figure;
using reports::Series;
using reports::Table;

/// The row nearest to a time.
const MotionRow& row_at(const meshes::FieldHistory& history, double time) {
  const auto after =
      std::ranges::lower_bound(history.motion, time * (1 - 1e-12), {}, [](const MotionRow& row) { return row.time; });
  if (after == history.motion.end()) return history.motion.back();
  if (after != history.motion.begin() && time - std::prev(after)->time < after->time - time) return *std::prev(after);
  return *after;
}

/// The comparison times at which the skeleton moves; where those are fewer than three, its beginning and times 1, 2, 5
/// times a power of ten after it. And the end.
std::vector<double> rows_of_interest(const meshes::FieldHistory& history, const Timeline& timeline) {
  const double begin = history.motion.front().time, end = history.motion.back().time;
  std::vector<double> times = timeline.comparison_times;
  std::erase_if(times, [&](double time) { return time < begin || time >= end; });
  if (times.size() < 3) {
    times = {begin};
    double power = std::pow(10, std::floor(std::log10(std::max(end - begin, 1e-300))) - 1);
    for (; begin + power < end; power *= 10)
      for (const double factor : {1.0, 2.0, 5.0})
        if (begin + factor * power < end) times.push_back(begin + factor * power);
  }
  times.push_back(end);
  return times;
}

/// What has come since a row: the first one is written some cycles after the stage began.
meshes::Point since(const meshes::Point& first, meshes::Point sum) {
  for (std::size_t axis = 0; axis < sum.size(); ++axis) sum[axis] -= first[axis];
  return sum;
}

/// "12.3; -45.6": components of a vector.
std::string components(const meshes::Point& vector, int dim) {
  std::string text;
  for (int axis = 0; axis < dim; ++axis) text += fmt::format("{}{:.4g}", axis == 0 ? "" : "; ", vector[axis]);
  return text;
}

Series series_of(const meshes::FieldHistory& history, const std::string& label,
                 const std::function<double(const MotionRow&)>& value) {
  Series series;
  series.label = label;
  // As many as a page needs: a slide has tens of thousands of rows.
  const std::size_t stride = 1 + history.motion.size() / 1000;
  for (std::size_t k = 0; k < history.motion.size(); k += stride) {
    series.x.push_back(history.motion[k].time - history.motion.front().time);
    series.y.push_back(value(history.motion[k]));
  }
  return series;
}

Figure energies(const meshes::FieldHistory& history, const std::string& axis) {
  Figure figure = figure_frame({"energy", "Energy of the skeleton", "Energy and momentum"}, {axis, "s"},
                               {"energy since it began to move", "J"});
  const double first = history.motion.front().potential;
  const auto add = [&](const char* label, const auto& value) {
    figure.series.push_back(series_of(history, label, value));
  };
  add("potential, change", [first](const MotionRow& row) { return row.potential - first; });
  add("stress work", [](const MotionRow& row) { return row.stress_work; });
  add("work of loads and water", [](const MotionRow& row) { return row.load_work; });
  add("resistance of sides, contact, damping", [](const MotionRow& row) { return row.resistance; });
  add("drift", [](const MotionRow& row) { return row.drift; });
  figure.series.back().style = Series::Style::dashed;
  const double share = std::abs(history.motion.back().drift) / energy_scale(history);
  figure.note = fmt::format("drift at the end {:.2g} % of the largest", 100 * share);
  return figure;
}

Figure kinetic(const meshes::FieldHistory& history, const std::string& axis) {
  Figure figure = figure_frame({"kinetic_energy", "Kinetic energy of the skeleton", "Energy and momentum"}, {axis, "s"},
                               {"kinetic energy", "J"});
  figure.series.push_back(series_of(history, "kinetic", [](const MotionRow& row) { return row.kinetic; }));
  return figure;
}

/// The momentum gained is the sum of the two impulses: their curves mirror each other but for it.
Figure momenta(const meshes::FieldHistory& history, const std::string& axis, int along) {
  const std::string name(1, "xyz"[along]);
  Figure figure =
      figure_frame({"momentum_" + name, "Momentum along " + name + ", and what explains it", "Energy and momentum"},
                   {axis, "s"}, {"momentum along " + name, "N s"});
  const auto add = [&](const char* label, const auto& value) {
    figure.series.push_back(series_of(history, label, value));
  };
  const MotionRow& first = history.motion.front();
  const auto impulse = [&](const MotionRow& row) { return row.impulse[along] - first.impulse[along]; };
  const auto reaction = [&](const MotionRow& row) { return row.reaction[along] - first.reaction[along]; };
  add("gained by the skeleton", [&](const MotionRow& row) { return row.momentum[along] - first.momentum[along]; });
  add("impulse of weight, loads, water", impulse);
  add("impulse of walls, base, damping", reaction);
  add("sum of the impulses", [&](const MotionRow& row) { return impulse(row) + reaction(row); });
  figure.series.back().style = Series::Style::dashed;
  return figure;
}

/// Water from the moment at which the skeleton begins to move.
std::vector<Figure> waters(const meshes::FieldHistory& history, const std::string& axis) {
  const double begin = history.motion.front().time;
  std::vector<meshes::LedgerRow> rows = history.ledger;
  std::erase_if(rows, [begin](const meshes::LedgerRow& row) { return row.time < begin * (1 - 1e-12); });
  if (rows.size() < 2) return {};
  const meshes::LedgerRow first = rows.front();
  const auto taken = [&](const meshes::LedgerRow& row) {
    return row.rain_asked - row.run_off - first.rain_asked + first.run_off;
  };
  const auto lost = [&](const meshes::LedgerRow& row) { return row.outflow - first.outflow; };
  Figure figure = figure_frame({"water_of_slide", "Water of the body while it moves", "Energy and momentum"},
                               {axis, "s"}, {"water", history.mesh.dim == 2 ? "l/m" : "l"});
  const auto add = [&](const char* label, const auto& value) {
    Series series;
    series.label = label;
    const std::size_t stride = 1 + rows.size() / 1000;
    for (std::size_t k = 0; k < rows.size(); k += stride) {
      series.x.push_back(rows[k].time - begin);
      series.y.push_back(1000 * value(rows[k]));
    }
    figure.series.push_back(std::move(series));
  };
  add("stored, change", [&](const meshes::LedgerRow& row) { return row.stored - first.stored; });
  add("rain taken in", taken);
  add("outflow", lost);
  add("taken in less outflow", [&](const meshes::LedgerRow& row) { return taken(row) - lost(row); });
  figure.series.back().style = Series::Style::dashed;
  const meshes::LedgerRow& last = rows.back();
  const double missing = last.stored - first.stored - taken(last) + lost(last);
  figure.note = fmt::format("the balance lacks {:.2g} of the water stored", std::abs(missing) / last.stored);
  return {figure};
}

}  // namespace

Table motion_table(const meshes::FieldHistory& history, const Timeline& timeline) {
  Table table;
  table.title = "Energy and momentum of the skeleton";
  table.section = "Energy and momentum";
  table.header = {"time [s]",
                  "since it began to move [s]",
                  "kinetic [J]",
                  "potential, change [J]",
                  "stress work [J]",
                  "work of loads [J]",
                  "resistance [J]",
                  "drift [J]",
                  "drift, share [%]",
                  "momentum gained [N s]",
                  "impulse of weight, loads, water [N s]",
                  "impulse of walls, base, damping [N s]",
                  "momentum, drift"};
  const double energy = energy_scale(history), momentum = momentum_scale(history);
  const MotionRow& first = history.motion.front();
  const int dim = history.mesh.dim;
  for (const double time : rows_of_interest(history, timeline)) {
    const MotionRow& row = row_at(history, time);
    table.rows.push_back(
        {fmt::format("{:.7g}", row.time), fmt::format("{:.4g}", row.time - first.time),
         fmt::format("{:.4g}", row.kinetic), fmt::format("{:.4g}", row.potential - first.potential),
         fmt::format("{:.4g}", row.stress_work), fmt::format("{:.4g}", row.load_work),
         fmt::format("{:.4g}", row.resistance), fmt::format("{:.3g}", row.drift),
         fmt::format("{:.2f}", 100 * row.drift / energy), components(since(first.momentum, row.momentum), dim),
         components(since(first.impulse, row.impulse), dim), components(since(first.reaction, row.reaction), dim),
         fmt::format("{:.1e}", magnitude(row.momentum_drift) / momentum)});
  }
  table.caption =
      "Per metre of thickness. Stress work is done on the soil, stored or dissipated; resistance is that of sides, "
      "contact and damping. Drift of energy is what the balance lacks, its share is of the largest entry: points keep "
      "motion that nodes do not see, and mapping back loses some. Momentum gained is the sum of the two impulses, "
      "given "
      "along x; y: its drift, of the largest of momentum and impulses, is round-off.";
  return table;
}

std::vector<Figure> motion_figures(const meshes::FieldHistory& history, bool after_failure) {
  if (history.motion.size() < 2) return {};
  const std::string axis = after_failure                         ? "time since failure"
                           : history.motion.front().time > 1e-12 ? "time since the skeleton began to move"
                                                                 : "time";
  std::vector<Figure> all = {kinetic(history, axis), energies(history, axis)};
  for (int along = 0; along < history.mesh.dim; ++along) all.push_back(momenta(history, axis, along));
  for (Figure& water : waters(history, axis)) all.push_back(std::move(water));
  return all;
}

}  // namespace wetfront::verification
