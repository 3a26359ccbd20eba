#pragma once

#include "reports/record.h"

#include <string>
#include <vector>

namespace wetfront::reports {

struct Tick {
  double at = 0;
  std::string label;  ///< empty: a minor tick
};

struct Axis {
  double from = 0, to = 1;
  bool log = false;
  std::vector<Tick> ticks;
};

struct FigureAxes {
  Axis x, y;
};

/// An axis over [from, to], widened to round ends. `log` needs from > 0.
Axis round_axis(double from, double to, bool log);

/// The axes of every figure. Panels of one section whose axes carry the same label, unit and kind share their range, so
/// that they compare at a glance; a panel whose own data would fill less than a fifth of it keeps its own.
std::vector<FigureAxes> choose_axes(const std::vector<Figure>& figures);

/// Points that cannot be drawn: not finite, or not positive on a logarithmic axis.
std::size_t undrawable_points(const Figure& figure, const Series& series);

}  // namespace wetfront::reports
