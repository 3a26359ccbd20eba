#include "reports/axes.h"

#include "reports/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace wetfront::reports {

namespace {

struct Range {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  bool empty() const { return from > to; }
  void add(double value) {
    from = std::min(from, value);
    to = std::max(to, value);
  }
  void add(const Range& other) {
    from = std::min(from, other.from);
    to = std::max(to, other.to);
  }
  double span(bool log) const { return log ? std::log10(to / from) : to - from; }
};

bool drawable(double value, bool log) {
  return std::isfinite(value) && (!log || value > 0);
}

Range data_range(const Figure& figure, bool along_x) {
  Range range;
  for (const Series& series : figure.series) {
    const std::size_t count = std::min(series.x.size(), series.y.size());
    for (std::size_t i = 0; i < count; ++i)
      if (drawable(series.x[i], figure.log_x) && drawable(series.y[i], figure.log_y))
        range.add(along_x ? series.x[i] : series.y[i]);
  }
  return range;
}

/// The 1, 2 or 5 times a power of ten that divides `span` into about five parts.
double round_step(double span) {
  const double raw = span / 5;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double mantissa = raw / power;
  return power * (mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : mantissa < 7.5 ? 5 : 10);
}

std::string linear_label(double value, double step, double largest) {
  if (std::abs(value) < 1e-9 * step) return "0";
  if (largest >= 1e6 || largest < 1e-2) return number_text(value);
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))),
                std::abs(value));
  return (value < 0 ? "\u2212" : "") + std::string(buffer);
}

Axis linear_axis(double from, double to) {
  if (!(to > from)) {
    const double half = from == 0 ? 0.5 : 0.1 * std::abs(from);
    from -= half;
    to += half;
  }
  const double step = round_step(to - from);
  const double half = step / 2;
  Axis axis;
  axis.from = half * std::floor(from / half + 1e-6);
  axis.to = half * std::ceil(to / half - 1e-6);
  const double largest = std::max(std::abs(axis.from), std::abs(axis.to));
  const auto first = std::llround(std::ceil(axis.from / step - 1e-6));
  const auto last = std::llround(std::floor(axis.to / step + 1e-6));
  for (auto i = first; i <= last; ++i) {
    const double at = step * static_cast<double>(i);
    axis.ticks.push_back({at, linear_label(at, step, largest)});
  }
  return axis;
}

Axis log_axis(double from, double to) {
  // Round ends are 1, 2 and 5 times powers of ten.
  const auto round_end = [](double value, bool down) {
    const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
    double best = down ? power : 10 * power;
    for (const double m : {1.0, 2.0, 5.0, 10.0}) {
      if (down && m * power <= value * (1 + 1e-9)) best = m * power;
      if (!down && m * power >= value * (1 - 1e-9)) {
        best = m * power;
        break;
      }
    }
    return best;
  };
  Axis axis;
  axis.log = true;
  axis.from = round_end(from, true);
  axis.to = round_end(to, false);
  if (!(axis.to > axis.from)) axis.to = 10 * axis.from;
  const double decades = std::log10(axis.to / axis.from);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 10)));
  const int first = static_cast<int>(std::floor(std::log10(axis.from) + 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(axis.to) + 1e-9));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int m = 1; m <= 9; ++m) {
      const double at = m * std::pow(10, exponent);
      if (at < axis.from * (1 - 1e-9) || at > axis.to * (1 + 1e-9)) continue;
      const bool between = decades <= 1.5 && (m == 2 || m == 5);
      if (m == 1 && exponent % every == 0)
        axis.ticks.push_back({at, power_of_ten(exponent)});
      else if (between)
        axis.ticks.push_back({at, std::to_string(m) + "·" + power_of_ten(exponent)});
      else if (decades <= 6)
        axis.ticks.push_back({at, ""});
    }
  }
  return axis;
}

struct AxisKey {
  std::string section, label, unit;
  bool log;
  bool operator==(const AxisKey&) const = default;
};

AxisKey key_of(const Figure& figure, bool along_x) {
  return along_x ? AxisKey{figure.section, figure.x_label, figure.x_unit, figure.log_x}
                 : AxisKey{figure.section, figure.y_label, figure.y_unit, figure.log_y};
}

Axis shared_axis(const std::vector<Figure>& figures, const Figure& figure, bool along_x) {
  const AxisKey key = key_of(figure, along_x);
  const Range own = data_range(figure, along_x);
  if (own.empty()) return key.log ? round_axis(1, 10, true) : round_axis(0, 1, false);
  Range all = own;
  for (const Figure& other : figures)
    for (const bool direction : {true, false})
      if (key_of(other, direction) == key) all.add(data_range(other, direction));
  const bool readable = 5 * own.span(key.log) >= all.span(key.log);
  const Range& chosen = readable ? all : own;
  return round_axis(chosen.from, chosen.to, key.log);
}

}  // namespace

Axis round_axis(double from, double to, bool log) {
  return log ? log_axis(from, to) : linear_axis(from, to);
}

std::vector<FigureAxes> choose_axes(const std::vector<Figure>& figures) {
  std::vector<FigureAxes> axes;
  for (const Figure& figure : figures)
    axes.push_back({shared_axis(figures, figure, true), shared_axis(figures, figure, false)});
  return axes;
}

std::size_t undrawable_points(const Figure& figure, const Series& series) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  std::size_t undrawable = 0;
  for (std::size_t i = 0; i < count; ++i)
    undrawable += !(std::isnan(series.x[i]) && std::isnan(series.y[i])) &&
                  (!drawable(series.x[i], figure.log_x) || !drawable(series.y[i], figure.log_y));
  return undrawable;
}

}  // namespace wetfront::reports
