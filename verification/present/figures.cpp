#include "verification/present/figures.h"

#include "meshes/evaluate.h"
#include "verification/compare/balance.h"
#include "verification/compare/profile.h"
#include "verification/present/body_figures.h"
#include "verification/present/figure_frame.h"
#include "verification/present/known.h"
#include "verification/present/motion_balance.h"
#include "verification/present/plane_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

constexpr double kPa = 1000;
constexpr double mm = 1e-3;

/// At most `most` entries of a long series, ends included: enough for a figure, small enough for a page.
std::vector<std::size_t> thinned(std::size_t size, std::size_t most = 400) {
  std::vector<std::size_t> index;
  const std::size_t stride = std::max<std::size_t>(1, (size + most - 1) / most);
  for (std::size_t i = 0; i < size; i += stride) index.push_back(i);
  if (size > 0 && index.back() != size - 1) index.push_back(size - 1);
  return index;
}

Series line_over_height(const meshes::FieldHistory& history, const std::vector<double>& nodal, double unit) {
  Series series;
  const int up = meshes::up_axis(history.mesh.dim);
  for (std::size_t i : thinned(nodal.size())) {
    series.x.push_back(nodal[i] / unit);
    series.y.push_back(history.mesh.nodes[i][up]);
  }
  return series;
}

Series points_over_height(const meshes::PointCloud& points, const std::vector<double>& value, double unit) {
  Series series;
  series.style = Series::Style::points;
  for (std::size_t i = 0; i < value.size(); ++i) {
    series.x.push_back(value[i] / unit);
    series.y.push_back(points.position[i][1]);
  }
  return series;
}

/// What the candidate is called: another code by its own name.
std::string name_of(const meshes::FieldHistory& candidate) {
  return candidate.solver.empty() || candidate.solver.starts_with("mpm") ? "MPM" : candidate.solver;
}

std::string errors_at(const std::vector<Measurement>& measurements, const std::string& quantity) {
  std::string text;
  for (const Measurement& m : measurements)
    if (m.quantity == quantity)
      text += fmt::format("{}{:.2g} %", text.empty() ? "relative L2 error: " : ", ", 100 * m.error);
  return text;
}

/// Which field of a profile a figure shows.
struct Field {
  std::string id, title, name, unit_name, quantity;
  double unit;
  std::vector<double> meshes::Snapshot::*nodal;
  std::vector<double> meshes::PointCloud::*at_points;
};

const std::vector<Field>& column_fields() {
  static const std::vector<Field> fields = {
      {"pressure_profile", "Pore pressure over height", "pore pressure", "kPa", "pressure_l2", kPa,
       &meshes::Snapshot::node_pressure, &meshes::PointCloud::pressure},
      {"saturation_profile", "Saturation over height", "degree of saturation", "-", "saturation_l2", 1,
       &meshes::Snapshot::node_saturation, &meshes::PointCloud::saturation}};
  return fields;
}

Figure profile_figure(const Field& field) {
  Figure figure = figure_frame({field.id, field.title, "Profiles"}, {field.name, field.unit_name}, {"elevation", "m"});
  return figure;
}

/// Reference as line, material points over it, one colour per time.
Figure profile(const Field& field, const Timeline& timeline, const Histories& histories) {
  Figure figure = profile_figure(field);
  const std::size_t times = std::min(histories.candidate.snapshots.size(), histories.reference.snapshots.size());
  for (std::size_t t = 0; t < times; ++t) {
    const std::string at = fmt::format("{:.4g} s", timeline.comparison_times[t]);
    const auto& snapshot = histories.candidate.snapshots[t];
    Series reference = line_over_height(histories.reference, histories.reference.snapshots[t].*field.nodal, field.unit);
    reference.label = "reference, " + at;
    Series candidate = points_over_height(snapshot.points, snapshot.points.*field.at_points, field.unit);
    candidate.label = name_of(histories.candidate) + " points, " + at;
    reference.colour = candidate.colour = static_cast<int>(t);
    figure.series.push_back(std::move(reference));
    figure.series.push_back(std::move(candidate));
  }
  return figure;
}

Figure error_profile(const Histories& histories, const Timeline& timeline) {
  Figure figure = figure_frame(
      {"pressure_difference", "Pressure difference in the cells, " + name_of(histories.candidate) + " minus reference",
       "Profiles"},
      {"pressure difference", "kPa"}, {"elevation", "m"});
  const auto candidate = cell_profiles(histories.candidate);
  const auto reference = profiles_at_cells(histories.reference, histories.candidate);
  for (std::size_t t = 0; t < std::min(candidate.size(), reference.size()); ++t) {
    Series series;
    series.label = fmt::format("{:.4g} s", timeline.comparison_times[t]);
    series.colour = static_cast<int>(t);
    for (std::size_t c = 0; c < candidate[t].pressure.size(); ++c) {
      series.x.push_back((candidate[t].pressure[c] - reference[t].pressure[c]) / kPa);
      series.y.push_back(histories.candidate.mesh.cell_centre(c)[meshes::up_axis(histories.candidate.mesh.dim)]);
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
}

Series gauge_series(const meshes::Gauge& gauge) {
  Series series;
  for (std::size_t i : thinned(gauge.time.size())) {
    series.x.push_back(gauge.time[i]);
    series.y.push_back(gauge.pressure[i] / kPa);
  }
  return series;
}

void add_gauges(Figure& figure, const meshes::FieldHistory& history, const std::string& who, Series::Style style) {
  int colour = 0;
  for (const meshes::Gauge& gauge : history.gauges) {
    Series series = gauge_series(gauge);
    series.label = who + ", " + gauge.name;
    series.style = style;
    series.colour = colour++;
    figure.series.push_back(std::move(series));
  }
}

Figure gauge_figure() {
  Figure figure = figure_frame({"pressure_at_probes", "Pore pressure at the probes", "Time series"}, {"time", "s"},
                               {"pore pressure", "kPa"});
  return figure;
}

using LedgerValue = std::function<double(const meshes::LedgerRow&)>;

Series ledger_series(const meshes::FieldHistory& history, double area, const std::string& label,
                     const LedgerValue& value) {
  Series series;
  series.label = label;
  for (std::size_t i : thinned(history.ledger.size())) {
    series.x.push_back(history.ledger[i].time);
    series.y.push_back(value(history.ledger[i]) / area / mm);
  }
  return series;
}

Figure ledger_figure(const meshes::FieldHistory& history, double area, const std::string& who) {
  Figure figure =
      figure_frame({"water_ledger", "Water of the " + who + ": asked, imposed, run off, delivered", "Flux audit"},
                   {"time of the run", "s"}, {"water per area", "mm"});
  const double stored = history.ledger.front().stored;
  const auto add = [&](const std::string& label, const LedgerValue& value) {
    figure.series.push_back(ledger_series(history, area, label, value));
  };
  add("rain asked", [](const auto& row) { return row.rain_asked; });
  add("imposed by the boundary", [](const auto& row) { return row.infiltrated; });
  add("run off", [](const auto& row) { return row.run_off; });
  add("delivered (stored + outflow)", [&](const auto& row) { return row.stored - stored + row.outflow; });
  figure.series.back().style = Series::Style::dashed;
  return figure;
}

Figure infiltration_figure(const Histories& histories, double area, double reference_area) {
  Figure figure = figure_frame({"cumulative_infiltration", "Cumulative infiltration and outflow", "Flux audit"},
                               {"time", "s"}, {"water per area", "mm"});
  const std::string who = name_of(histories.candidate);
  const auto infiltrated = [](const meshes::LedgerRow& row) { return row.infiltrated; };
  const auto outflow = [](const meshes::LedgerRow& row) { return row.outflow; };
  figure.series.push_back(ledger_series(histories.reference, reference_area, "reference, infiltrated", infiltrated));
  figure.series.push_back(ledger_series(histories.candidate, area, who + ", infiltrated", infiltrated));
  figure.series.push_back(ledger_series(histories.reference, reference_area, "reference, outflow", outflow));
  figure.series.push_back(ledger_series(histories.candidate, area, who + ", outflow", outflow));
  for (int i : {1, 3}) figure.series[i].style = Series::Style::dashed;
  for (int i = 0; i < 4; ++i) figure.series[i].colour = i / 2;
  return figure;
}

Series step_series(const meshes::FieldHistory& history, const std::string& label) {
  Series series;
  series.label = label;
  for (std::size_t i : thinned(history.ledger.size() - 1)) {
    const double step = history.ledger[i + 1].time - history.ledger[i].time;
    if (!(step > 0)) continue;
    series.x.push_back(history.ledger[i + 1].time);
    series.y.push_back(step);
  }
  return series;
}

Figure step_figure() {
  Figure figure = figure_frame({"time_steps", "Time steps taken", "Cost"}, {"time", "s"}, {"step", "s"});
  figure.log_y = true;
  return figure;
}

/// Whether the skeleton began to move because a stage ended with failure, before its time was over.
bool moves_by_failure(const Scene& scene, const meshes::FieldHistory& history) {
  if (history.motion.empty()) return false;
  const Timeline planned = timeline(scene);
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    if (scene.stages[i].event.kind == StageEvent::Kind::failure &&
        history.motion.front().time < planned.stage_end[i] * (1 - 1e-9))
      return true;
  return false;
}

/// What a skeleton that deforms has to show.
void add_motion(std::vector<Figure>& all, const Scene& scene, const meshes::FieldHistory& history) {
  for (Figure& picture : body_figures(history)) all.push_back(std::move(picture));
  for (Figure& picture : motion_figures(history, moves_by_failure(scene, history))) all.push_back(std::move(picture));
}

/// The reference goes on when the body has come to rest: what it says then has nothing beside it.
void end_at(Figure& figure, double end) {
  for (Series& series : figure.series) {
    std::size_t count = 0;
    while (count < series.x.size() && series.x[count] <= end * (1 + 1e-12)) ++count;
    series.x.resize(count);
    series.y.resize(count);
  }
}

}  // namespace

std::vector<Figure> figures(const Scene& scene, const Timeline& timeline, const Histories& histories,
                            const std::vector<Measurement>& measurements) {
  std::vector<Figure> all;
  const std::string who = name_of(histories.candidate);
  const double area = std::max(rain_area(scene, histories.candidate.mesh), 1e-300);
  if (std::holds_alternative<Column>(scene.geometry.shape)) {
    for (const Field& field : column_fields()) {
      all.push_back(profile(field, timeline, histories));
      all.back().note = errors_at(measurements, field.quantity);
    }
    all.push_back(error_profile(histories, timeline));
  }
  if (!std::holds_alternative<Column>(scene.geometry.shape))
    for (Figure& picture : plane_comparison(histories)) all.push_back(std::move(picture));
  add_motion(all, scene, histories.candidate);
  Figure gauges = gauge_figure();
  add_gauges(gauges, histories.reference, "reference", Series::Style::line);
  add_gauges(gauges, histories.candidate, who, Series::Style::dashed);
  if (!histories.candidate.ledger.empty()) end_at(gauges, histories.candidate.ledger.back().time);
  draw_known_rises(gauges, scene, histories.candidate);
  if (!gauges.series.empty()) all.push_back(std::move(gauges));
  if (!scene.rains.empty()) {
    all.push_back(infiltration_figure(histories, area, std::max(rain_area(scene, histories.reference.mesh), 1e-300)));
    if (!histories.candidate.ledger.empty()) end_at(all.back(), histories.candidate.ledger.back().time);
    all.push_back(ledger_figure(histories.candidate, area, who));
  }
  Figure steps = step_figure();
  steps.series = {step_series(histories.reference, "reference"), step_series(histories.candidate, who)};
  if (!histories.candidate.ledger.empty()) end_at(steps, histories.candidate.ledger.back().time);
  all.push_back(std::move(steps));
  return all;
}

std::vector<Figure> figures_of_one(const Scene& scene, const meshes::FieldHistory& history, const std::string& who) {
  std::vector<Figure> all;
  add_motion(all, scene, history);
  const bool wet = scene.water.has_value();
  for (const Field& field : column_fields()) {
    if (!wet || !std::holds_alternative<Column>(scene.geometry.shape)) break;
    Figure figure = profile_figure(field);
    for (const meshes::Snapshot& snapshot : history.snapshots) {
      Series series = line_over_height(history, snapshot.*field.nodal, field.unit);
      series.label = fmt::format("{:.4g} s", snapshot.time);
      figure.series.push_back(std::move(series));
    }
    if (!figure.series.empty()) all.push_back(std::move(figure));
  }
  if (wet)
    for (Figure& picture : plane_figures(history, who)) all.push_back(std::move(picture));
  Figure gauges = gauge_figure();
  if (wet) add_gauges(gauges, history, who, Series::Style::line);
  if (wet) draw_known_rises(gauges, scene, history);
  if (!gauges.series.empty()) all.push_back(std::move(gauges));
  if (!scene.rains.empty() && !history.ledger.empty())
    all.push_back(ledger_figure(history, std::max(rain_area(scene, history.mesh), 1e-300), who));
  if (history.ledger.size() > 2) {
    Figure steps = step_figure();
    steps.series = {step_series(history, who)};
    all.push_back(std::move(steps));
  }
  return all;
}

}  // namespace wetfront::verification
