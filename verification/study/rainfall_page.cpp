#include "verification/study/rainfall_page.h"

#include "verification/compare/body_outcomes.h"
#include "verification/present/figure_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

const std::string section = "Rain and slope";
/// What Lee et al. 2021 conclude from their seven intensities.
constexpr double papers_critical_ratio = 0.5;

double outcome(const RainOutcome& rain, const std::string& name) {
  return value_of(rain.result->candidate, name);
}

/// "deep", "base first"; empty where it is not known.
std::string meaning(const RainOutcome& rain, const std::string& name) {
  const Outcome* found = find_outcome(rain.result->candidate, name);
  return found ? in_words(*found) : "";
}

Change change_of(const std::vector<RainOutcome>& rain, const std::string& name) {
  Change change;
  const RainOutcome* before = nullptr;
  for (const RainOutcome& one : rain) {
    if (meaning(one, name).empty()) continue;
    if (before && meaning(*before, name) != meaning(one, name)) {
      if (change.found)
        change.once = false;
      else
        change = {true, before->ratio, one.ratio, true};
    }
    before = &one;
  }
  return change;
}

std::set<std::string> gauges_of(const std::vector<RainOutcome>& rain) {
  static const std::string rate = "rise_rate:";
  std::set<std::string> names;
  for (const RainOutcome& one : rain)
    for (const Outcome& about : one.result->candidate)
      if (about.name.starts_with(rate)) names.insert(about.name.substr(rate.size()));
  return names;
}

Figure over_ratio(const std::vector<RainOutcome>& rain, const std::string& id, const std::string& title,
                  const FigureAxis& y) {
  Figure figure = figure_frame({id, title, section}, {"rain over conductivity, I/k_s", "1"}, y);
  figure.log_x = rain.front().ratio > 0 && rain.back().ratio / rain.front().ratio > 10;
  return figure;
}

/// A curve for each gauge.
Figure of_gauges(const std::vector<RainOutcome>& rain, Figure figure, const std::string& name,
                 const std::function<double(const RainOutcome&)>& unit) {
  int colour = 0;
  for (const std::string& gauge : gauges_of(rain)) {
    Series line{gauge, Series::Style::line, {}, {}, colour}, points{"", Series::Style::points, {}, {}, colour};
    for (const RainOutcome& one : rain) {
      const double y = outcome(one, name + ":" + gauge) / unit(one);
      if (std::isfinite(y)) line.x.push_back(one.ratio), line.y.push_back(y);
    }
    points.x = line.x, points.y = line.y;
    ++colour;
    if (line.x.empty()) continue;
    figure.series.push_back(std::move(line));
    figure.series.push_back(std::move(points));
  }
  return figure;
}

/// One curve, its points told apart by how the slope failed.
Figure of_slides(const std::vector<RainOutcome>& rain, Figure figure, const std::string& name) {
  Series line{"MPM", Series::Style::line, {}, {}, 7};
  Series deep{"deep failure", Series::Style::points, {}, {}, 0},
      shallow{"shallow failure", Series::Style::points, {}, {}, 1},
      none{"did not fail", Series::Style::points, {}, {}, 2};
  for (const RainOutcome& one : rain) {
    const double y = outcome(one, name);
    if (!std::isfinite(y)) continue;
    const std::string type = meaning(one, "failure_depth");
    for (Series* series : {&line, type.empty() ? &none : type == "deep" ? &deep : &shallow})
      series->x.push_back(one.ratio), series->y.push_back(y);
  }
  for (Series* series : {&line, &deep, &shallow, &none})
    if (!series->x.empty()) figure.series.push_back(std::move(*series));
  return figure;
}

std::string cell(double value, const char* format = "{:.3g}") {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "never";
}

std::string or_dash(const std::string& words) {
  return words.empty() ? "-" : words;
}

std::string sentence(const std::string& what, const Change& change) {
  if (!change.found) return what + " is the same at all of these intensities.";
  return fmt::format("{} changes between I/k_s = {:.2g} and {:.2g}{}.", what, change.below, change.above,
                     change.once ? "" : ", and not only there: no single ratio parts the two");
}

std::string verdict_on_paper(const Change& failure) {
  const std::string paper =
      fmt::format("The critical ratio of {:.1f} that Lee et al. (2021) read from their runs ", papers_critical_ratio);
  if (!failure.found) return paper + "is not seen here.";
  if (!failure.once) return paper + "is no clear limit here.";
  const bool holds = failure.below <= papers_critical_ratio && papers_critical_ratio <= failure.above;
  return paper + (holds ? "lies where the type of failure changes here."
                        : fmt::format("is not where the type of failure changes here: that is {} it.",
                                      failure.below > papers_critical_ratio ? "above" : "below"));
}

reports::Table table_of(const std::vector<RainOutcome>& rain) {
  const auto gauges = gauges_of(rain);
  reports::Table table{"What rain of each intensity does", section, "", {"I/k_s"}, {}};
  const Change failure = change_of_failure(rain);
  table.caption = sentence("The order of wetting", change_of_wetting(rain)) + " " +
                  sentence("The type of failure", failure) + " " + verdict_on_paper(failure) +
                  " Deep or shallow: by the depth of what had moved when the slope failed, over the thickness; one "
                  "half parts them.";
  for (const char* title : {"wet first", "surface refuses rain [s]", "fails at [s]", "type", "depth [-]", "from x [m]",
                            "to x [m]", "displacement [m]", "velocity [m/s]"})
    table.header.emplace_back(title);
  for (const std::string& gauge : gauges) table.header.push_back("rise at " + gauge + " over k_s [-]");
  for (const RainOutcome& one : rain) {
    std::vector<std::string> row = {cell(one.ratio),
                                    or_dash(meaning(one, "wetting_order")),
                                    cell(outcome(one, "ponding_time"), "{:.0f}"),
                                    cell(outcome(one, "failure_time"), "{:.0f}"),
                                    or_dash(meaning(one, "failure_depth")),
                                    cell(outcome(one, "failure_depth"), "{:.2f}"),
                                    cell(outcome(one, "failure_from"), "{:.1f}"),
                                    cell(outcome(one, "failure_to"), "{:.1f}"),
                                    cell(outcome(one, "largest_displacement")),
                                    cell(outcome(one, "largest_velocity"))};
    for (const std::string& gauge : gauges) row.push_back(cell(outcome(one, "rise_rate:" + gauge) / one.conductivity));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Change change_of_wetting(const std::vector<RainOutcome>& rain) {
  return change_of(rain, "wetting_order");
}

Change change_of_failure(const std::vector<RainOutcome>& rain) {
  return change_of(rain, "failure_depth");
}

bool told_with_rain(const Outcome& outcome) {
  return outcome.name.starts_with("rise_rate:") || outcome.name.starts_with("arrival_time:") ||
         outcome.name == "largest_displacement" || outcome.name == "largest_velocity";
}

void tell_rain(reports::Record& record, std::vector<RainOutcome> rain) {
  std::erase_if(rain,
                [](const RainOutcome& one) { return find_outcome(one.result->candidate, "failure_time") == nullptr; });
  if (rain.size() < 2) return;
  std::ranges::sort(rain, {}, &RainOutcome::ratio);
  record.tables.insert(record.tables.begin(), table_of(rain));
  std::vector<Figure> panels = {
      of_gauges(rain, over_ratio(rain, "rain_rise_speed", "(A) speed of rise of head", {"v / k_s", "1"}), "rise_rate",
                [](const RainOutcome& one) { return one.conductivity; }),
      of_gauges(rain, over_ratio(rain, "rain_rise_time", "(B) time of first rise", {"time of first rise", "s"}),
                "arrival_time", [](const RainOutcome&) { return 1.0; }),
      of_slides(rain,
                over_ratio(rain, "rain_displacement", "(C) largest displacement of a marker", {"displacement", "m"}),
                "largest_displacement"),
      of_slides(rain, over_ratio(rain, "rain_velocity", "(D) largest velocity of a marker", {"velocity", "m/s"}),
                "largest_velocity")};
  panels[0].log_y = panels[1].log_y = true;
  std::erase_if(panels, [](const Figure& panel) { return panel.series.empty(); });
  record.figures.insert(record.figures.begin(), panels.begin(), panels.end());
}

}  // namespace wetfront::verification
