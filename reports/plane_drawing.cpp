#include "reports/plane_drawing.h"

#include "reports/axes.h"
#include "reports/escape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace wetfront::reports {

namespace {

// Tenths of a pixel around the plane.
constexpr double before = 420, after = 120, above = 60, below = 260;

}  // namespace

Extent Extent::nothing() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {far, -far, far, -far};
}

void Extent::include(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  left = std::min(left, x);
  right = std::max(right, x);
  bottom = std::min(bottom, y);
  top = std::max(top, y);
}

PlaneDrawing::PlaneDrawing(const Extent& extent, double width) : extent_(extent), width_(10 * width) {
  if (!(extent_.left <= extent_.right)) extent_ = {};
  const double wide = extent_.right - extent_.left, high = extent_.top - extent_.bottom;
  const double least = std::max({1e-9, 1e-3 * wide, 1e-3 * high});
  if (wide < least) extent_.right += least;
  if (high < least) extent_.top += least;
  const double room = width_ - before - after;
  // Not taller than wide: what is upright is drawn narrower.
  scale_ = room / std::max(extent_.right - extent_.left, extent_.top - extent_.bottom);
}

double PlaneDrawing::x0() const {
  return before - extent_.left * scale_;
}

double PlaneDrawing::y0() const {
  return above + extent_.top * scale_;
}

long PlaneDrawing::x(double metres) const {
  return std::lround(x0() + metres * scale_);
}

long PlaneDrawing::y(double metres) const {
  return std::lround(y0() - metres * scale_);
}

double PlaneDrawing::height() const {
  return above + (extent_.top - extent_.bottom) * scale_ + below;
}

std::string PlaneDrawing::open(const std::string& label) const {
  std::ostringstream out;
  out << "<svg role=\"img\" aria-label=\"" << html(label) << "\" viewBox=\"0 0 " << width_ << " "
      << std::lround(height()) << "\" font-size=\"110\" fill=\"currentColor\">";
  return out.str();
}

std::string PlaneDrawing::frame() const {
  std::ostringstream out;
  const long left = x(extent_.left), right = x(extent_.right), top = y(extent_.top), bottom = y(extent_.bottom);
  out << "<path d=\"M" << left << " " << top << "V" << bottom << "H" << right
      << "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"8\" stroke-opacity=\".6\"/>";
  const auto each_tick = [](double from, double to, double room, const auto& draw) {
    double next = -1e300;
    for (const Tick& tick : round_axis(from, to, false).ticks) {
      const double slack = 1e-9 * (to - from);
      if (tick.label.empty() || tick.at < from - slack || tick.at > to + slack || tick.at < next) continue;
      draw(tick);
      next = tick.at + room;
    }
  };
  each_tick(extent_.left, extent_.right, 400 / scale_, [&](const Tick& tick) {
    out << "<path d=\"M" << x(tick.at) << " " << bottom
        << "v40\" stroke=\"currentColor\" stroke-width=\"8\"/><text x=\"" << x(tick.at) << "\" y=\"" << bottom + 150
        << "\" text-anchor=\"middle\">" << html(tick.label) << "</text>";
  });
  each_tick(extent_.bottom, extent_.top, 160 / scale_, [&](const Tick& tick) {
    out << "<path d=\"M" << left << " " << y(tick.at) << "h-40\" stroke=\"currentColor\" stroke-width=\"8\"/><text x=\""
        << left - 60 << "\" y=\"" << y(tick.at) + 38 << "\" text-anchor=\"end\">" << html(tick.label) << "</text>";
  });
  out << "<text x=\"" << right << "\" y=\"" << bottom + 245 << "\" text-anchor=\"end\">m</text>";
  return out.str();
}

}  // namespace wetfront::reports
