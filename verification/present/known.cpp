#include "verification/present/known.h"

#include "verification/compare/events.h"
#include "verification/scene/known_value.h"
#include "verification/translate/initial_pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

constexpr double kPa = 1000;
constexpr double broken = std::numeric_limits<double>::quiet_NaN();
constexpr int grey = 6;  // of the palette: no probe's or marker's own colour

struct Told {
  Source source;
  const char* name;
};
constexpr Told told[] = {{Source::measured, "measured"}, {Source::simulated, "published"}};

/// First rise at a probe as the source has it, perhaps by way of another probe's and the time between; else the
/// candidate's own.
double first_rise(const Scene& scene, const meshes::Gauge& gauge, Source source) {
  if (const auto known = known_value(scene, "arrival_time:" + gauge.name, source)) return known->low;
  for (const Probe& other : scene.probes) {
    const auto from = known_value(scene, "arrival_time:" + other.name, source);
    const auto between = known_value(scene, "interval:" + other.name + ":" + gauge.name, source);
    if (from && between) return from->low + between->low;
  }
  return crossing_time(gauge, arrival_pressure);
}

void draw_rise(Figure& figure, const Scene& scene, const meshes::Gauge& gauge, const Told& by, int colour) {
  const auto rate = known_value(scene, "rise_rate:" + gauge.name, by.source);
  const double from = first_rise(scene, gauge, by.source);
  if (!rate || std::isnan(from)) return;
  const double steepness = rate->low * scene.water->density * gravity_magnitude(scene);  // Pa/s
  Series line;
  line.label = fmt::format("{}, {}: {:.2g} m/s", by.name, gauge.name, rate->low);
  line.style = by.source == Source::measured ? Series::Style::line : Series::Style::dashed;
  line.colour = colour;
  line.x = {from, from + (risen_pressure - arrival_pressure) / steepness};
  line.y = {arrival_pressure / kPa, risen_pressure / kPa};
  figure.series.push_back(std::move(line));
}

std::string more_or_less(const std::string& quantity, bool more) {
  if (quantity == "failure_time" || quantity.starts_with("arrival_time:")) return more ? "later" : "earlier";
  if (quantity == "slide_duration" || quantity.starts_with("interval:")) return more ? "longer" : "shorter";
  return more ? "more" : "less";
}

/// "11 times less than measured", "12 % more than published", "as measured".
std::string against(const Observation& known, const Told& by, double here) {
  const auto band = known_value(known, by.source);
  if (!band) return "";
  const double off = relative_distance(here, *band);
  if (off < 0.005) return std::string("as ") + by.name;
  if (here * band->low < 0) return std::string("in the other order than ") + by.name;  // of two probes
  const bool more = here > band->high;
  const std::string than = more_or_less(known.quantity, more) + " than " + by.name;
  const double times = more ? here / band->high : band->low / here;
  if (times >= 2) return fmt::format("{:.2g} times {}", times, than);
  return fmt::format("{:.2g} % {}", 100 * off, than);
}

}  // namespace

void draw_known_rises(Figure& figure, const Scene& scene, const meshes::FieldHistory& candidate) {
  // Colours after those of the probes, so that what is known stands out against what came out.
  int colour = static_cast<int>(candidate.gauges.size());
  for (const meshes::Gauge& gauge : candidate.gauges) {
    for (const Told& by : told) draw_rise(figure, scene, gauge, by, colour);
    ++colour;
  }
  double top = 0;
  for (const Series& series : figure.series)
    for (const double y : series.y) top = std::max(top, y);
  for (const Told& by : told)
    if (const auto failure = known_value(scene, "failure_time", by.source); failure && !figure.series.empty())
      figure.series.push_back({fmt::format("failure, {}: {:.6g} s", by.name, failure->low),
                               by.source == Source::measured ? Series::Style::line : Series::Style::dashed,
                               {failure->low, failure->low},
                               {0, top},
                               grey});
}

void draw_known_displacement(Figure& figure, const Scene& scene) {
  double begin = 0, end = 0;
  for (const Series& series : figure.series)
    for (const double x : series.x) begin = std::min(begin, x), end = std::max(end, x);
  for (const Told& by : told) {
    const auto way = known_value(scene, "largest_displacement", by.source);
    if (!way) continue;
    Series lines;
    lines.label = way->low < way->high ? fmt::format("{}: {:.3g} to {:.3g} m", by.name, way->low, way->high)
                                       : fmt::format("{}: {:.3g} m", by.name, way->low);
    lines.style = by.source == Source::measured ? Series::Style::line : Series::Style::dashed;
    lines.colour = grey;
    lines.x = {begin, end};
    lines.y = {way->low, way->low};
    if (way->low < way->high) {
      lines.x.insert(lines.x.end(), {broken, begin, end});
      lines.y.insert(lines.y.end(), {broken, way->high, way->high});
    }
    figure.series.push_back(std::move(lines));
  }
}

std::string difference_of_meshes(const Outcome* here, const Outcome* second) {
  if (here == nullptr || second == nullptr || std::isnan(here->value) || std::isnan(second->value)) return "-";
  const double apart = std::abs(here->value - second->value);
  std::string text = fmt::format("{:.3g}{}", apart, here->unit == "-" ? "" : " " + here->unit);
  if (here->value != 0) text += fmt::format(", {:.2g} %", 100 * apart / std::abs(here->value));
  return text;
}

std::string in_a_sentence(const Observation& known, const Outcome* here, const Outcome* second) {
  if (here == nullptr || std::isnan(here->value)) return "it did not happen here";
  std::string text;
  for (const Told& by : told)
    if (const std::string part = against(known, by, here->value); !part.empty())
      text += (text.empty() ? "here " : ", ") + part;
  if (second == nullptr) return text;
  if (!text.empty()) text += "; ";
  if (std::isnan(second->value)) return text + "on the second mesh it did not happen";
  return text + fmt::format("the two meshes differ by {:.2g} %",
                            100 * std::abs(here->value - second->value) / std::abs(here->value));
}

}  // namespace wetfront::verification
