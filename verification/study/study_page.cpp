#include "verification/study/study_page.h"

#include "verification/compare/body_outcomes.h"
#include "verification/compare/verdict.h"
#include "verification/present/figure_frame.h"
#include "verification/run/scene_record.h"
#include "verification/scene/read.h"
#include "verification/scene/units.h"
#include "verification/study/rainfall_page.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/scene_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

std::string number(double value) {
  return std::isnan(value) ? "never" : fmt::format("{:.5g}", value);
}

/// The gate that comes nearest to failing, or fails most: "front_position 42 %".
std::string worst_gate(const PointResult& result) {
  const reports::Finding* worst = nullptr;
  const auto share = [](const reports::Finding& finding) { return finding.error / finding.tolerance; };
  for (const auto& finding : result.findings)
    if (finding.tolerance > 0 && (!worst || !(share(finding) <= share(*worst)))) worst = &finding;
  return worst ? fmt::format("{} {:.3g} %", worst->quantity, 100 * share(*worst)) : "";
}

reports::Table points_table(const std::vector<Variation>& variations, const std::vector<PointResult>& results,
                            const std::vector<StudyPoint>& points, const std::filesystem::path& out) {
  reports::Table table{"Points",
                       "Verdicts",
                       "Each leads to its own report. Worst gate: its error as a share of its tolerance.",
                       {"point"},
                       {}};
  for (const Variation& variation : variations) table.header.push_back(variation.path);
  for (const char* title : {"verdict", "MPM CPU [s]", "worst gate", "remark"}) table.header.push_back(title);
  for (std::size_t i = 0; i < results.size(); ++i) {
    std::vector<std::string> row{std::to_string(i)};
    for (const Setting& setting : points[i].settings)
      row.push_back(setting.value.empty() ? "(left out)" : setting.value);
    row.push_back(verdict_of(results[i]));
    row.push_back(fmt::format("{:.3g}", results[i].candidate_cpu));
    row.push_back(worst_gate(results[i]));
    row.push_back(results[i].message);
    table.rows.push_back(std::move(row));
    table.links.push_back(link_to(out, i, points[i]));
  }
  return table;
}

const std::vector<Outcome>& list_of_outcomes(const std::vector<PointResult>& results) {
  static const std::vector<Outcome> none;
  const auto any = std::ranges::find_if(results, [](const PointResult& one) { return !one.candidate.empty(); });
  return any == results.end() ? none : any->candidate;
}

reports::Table outcomes_table(const std::vector<PointResult>& results) {
  reports::Table table{"Outcomes of the MPM", "Outcomes", "In brackets: the reference's.", {"point"}, {}};
  const auto& names = list_of_outcomes(results);
  for (const Outcome& one : names) table.header.push_back(one.description + " [" + one.unit + "]");
  for (std::size_t i = 0; i < results.size(); ++i) {
    std::vector<std::string> row{results[i].name};
    for (const Outcome& one : names) {
      const Outcome* candidate = find_outcome(results[i].candidate, one.name);
      const Outcome* reference = find_outcome(results[i].reference, one.name);
      const std::string meaning = candidate ? in_words(*candidate) : "";
      row.push_back((candidate ? number(candidate->value) : "-") + (meaning.empty() ? "" : ", " + meaning) +
                    (reference ? " (" + number(reference->value) + ")" : ""));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Number of the first variation whose values are all numbers, what it is called on an axis, and how much one of its
/// units is there.
struct Abscissa {
  std::size_t variation;
  std::string label, unit;
  double scale = 1;
  double conductivity = 0;  ///< k_s [m/s] that rain is told by; 0: it is not
};

/// Rain on one soil is told by its conductivity: what the ground takes decides, not the millimetres.
void tell_by_conductivity(const Scene& scene, Abscissa& rain) {
  if (scene.soils.size() != 1 || !scene.water || !rain.label.starts_with("rain") || !rain.label.ends_with(".intensity"))
    return;
  const auto one = read_quantity("1 " + rain.unit, "m/s");
  const double gravity = gravity_magnitude(scene);
  if (!std::holds_alternative<double>(one) || !(gravity > 0)) return;
  const double conductivity =
      scene.soils[0].intrinsic_permeability * scene.water->density * gravity / scene.water->viscosity;
  rain = {rain.variation, rain.label + " / k_s", "1", std::get<double>(one) / conductivity, conductivity};
}

std::optional<Abscissa> abscissa(const std::vector<Variation>& variations, const Scene& scene) {
  for (std::size_t v = 0; v < variations.size(); ++v) {
    const auto& values = variations[v].values;
    const bool numbers =
        std::ranges::none_of(values, [](const auto& value) { return number_and_unit(value).number.empty(); });
    const std::string unit = number_and_unit(values.front()).unit;
    if (!numbers || values.size() < 2) continue;
    Abscissa found{v, variations[v].path, unit.empty() ? written_unit(scene.text, variations[v].path) : unit};
    tell_by_conductivity(scene, found);
    return found;
  }
  return {};
}

double number_in(const std::string& text) {
  return std::stod(number_and_unit(text).number);
}

Figure figure_of(const Outcome& about, const Abscissa& along, const std::vector<Variation>& variations,
                 const std::vector<StudyPoint>& points, const std::vector<PointResult>& results) {
  std::string id = about.name;
  std::ranges::replace_if(
      id, [](unsigned char c) { return !std::isalnum(c) && c != '_'; }, '-');
  const Variation& varied = variations[along.variation];
  Figure figure =
      figure_frame({id, about.description, "Outcomes"}, {along.label, along.unit.empty() ? "1" : along.unit},
                   {about.name.substr(0, about.name.find_first_of("@:")), about.unit});
  std::vector<double> x;
  for (const std::string& value : varied.values) x.push_back(along.scale * number_in(value));
  const auto [low, high] = std::ranges::minmax(x);
  figure.log_x = low > 0 && high / low > 20;
  std::map<std::string, int> curve_of;  // of the other settings
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Outcome* candidate = find_outcome(results[i].candidate, about.name);
    if (!candidate) continue;
    std::string others;
    for (std::size_t s = 0; s < points[i].settings.size(); ++s)
      if (s != along.variation)
        others += (others.empty() ? "" : ", ") + points[i].settings[s].path + "=" + points[i].settings[s].value;
    const auto [curve, fresh] = curve_of.emplace(others, static_cast<int>(curve_of.size()));
    if (fresh) {
      figure.series.push_back(
          {others.empty() ? "MPM" : "MPM, " + others, Series::Style::points, {}, {}, curve->second});
      figure.series.push_back(
          {others.empty() ? "reference" : "reference, " + others, Series::Style::line, {}, {}, curve->second});
    }
    const double at = along.scale * number_in(points[i].settings[along.variation].value);
    const auto put = [&](Series& series, double y) {
      if (std::isfinite(y)) series.x.push_back(at), series.y.push_back(y);
    };
    put(figure.series[2 * curve->second], candidate->value);
    put(figure.series[2 * curve->second + 1], value_of(results[i].reference, about.name));
  }
  std::erase_if(figure.series, [](const Series& series) { return series.x.empty(); });
  return figure;
}

}  // namespace

namespace {

/// Figures of what never changes are left out: the table has it.
bool varies(const Figure& figure) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Series& series : figure.series)
    for (const double y : series.y) low = std::min(low, y), high = std::max(high, y);
  return high - low > 1e-3 * std::max(std::abs(low), std::abs(high));
}

/// Rain alone is varied, on a slope that is followed as it slides: its outcomes belong together.
void add_rain(reports::Record& record, const Abscissa& along, const std::vector<StudyPoint>& points,
              const std::vector<PointResult>& results) {
  std::vector<RainOutcome> rain;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!results[i].candidate.empty())
      rain.push_back(
          {along.scale * number_in(points[i].settings[along.variation].value), along.conductivity, &results[i]});
  tell_rain(record, std::move(rain));
}

}  // namespace

std::string verdict_of(const PointResult& result) {
  if (result.exit == static_cast<int>(Exit::bad_input)) return "refused";
  if (result.exit == static_cast<int>(Exit::gave_up)) return "gave up";
  return word(overall(result.findings));
}

std::string link_to(const std::filesystem::path& out, std::size_t index, const StudyPoint& point) {
  const auto folder = point_folder(out, index, point);
  const std::string name = folder.filename().string();
  return std::filesystem::exists(folder / "report.html") ? name + "/report.html" : name + "/run.log";
}

reports::Record start_study(const std::string& kind, const Scene& scene, const std::vector<PointResult>& results) {
  reports::Record record = record_of(scene, mpm_mesh(scene));
  record.kind = kind;
  std::vector<reports::Finding> verdicts;
  for (const PointResult& result : results) {
    record.cpu_seconds += result.candidate_cpu;
    verdicts.emplace_back().verdict = overall(result.findings);
    if (!result.ran()) verdicts.back().verdict = reports::Verdict::inconclusive;
    if (!result.message.empty()) record.log.push_back(result.name + ": " + result.message);
  }
  record.verdict = overall(verdicts);
  return record;
}

reports::Record vary_page(const Scene& scene, const std::vector<Variation>& variations,
                          const std::vector<PointResult>& results, const std::filesystem::path& out) {
  reports::Record record = start_study("parametric study", scene, results);
  const std::vector<StudyPoint> points = product(variations);
  record.tables.push_back(points_table(variations, results, points, out));
  record.tables.push_back(outcomes_table(results));
  const auto along = abscissa(variations, scene);
  if (!along) return record;
  const auto varied = [](const Variation& one) { return one.values.size() > 1; };
  const bool rain = std::ranges::count_if(variations, varied) == 1 && along->conductivity > 0 && follows_a_body(scene);
  for (const Outcome& about : list_of_outcomes(results)) {
    if (told_the_other_way(about) || (rain && told_with_rain(about))) continue;
    Figure figure = figure_of(about, *along, variations, points, results);
    if (varies(figure)) record.figures.push_back(std::move(figure));
  }
  if (rain) add_rain(record, *along, points, results);
  return record;
}

}  // namespace wetfront::verification
