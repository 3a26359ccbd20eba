#include "reports/colour_bands.h"

#include "reports/axes.h"
#include "reports/colour_scale.h"
#include "reports/escape.h"
#include "reports/number_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wetfront::reports {

namespace {

/// Pressures carry both texts; the page shows one of them (page.css), a drawing by itself the first.
std::string both_units(const std::string& place, const std::string& pressure, const std::string& head) {
  if (head.empty()) return "<text " + place + ">" + pressure + "</text>";
  return "<text class=\"as-pressure\" " + place + ">" + pressure + "</text><text class=\"as-head\" display=\"none\" " +
         place + ">" + head + "</text>";
}

std::string named(const std::string& quantity, const std::string& unit) {
  return html(quantity + (unit.empty() || unit == "1" || unit == "-" ? "" : " [" + unit + "]"));
}

}  // namespace

std::size_t ColourBands::band_of(double value) const {
  const auto above = std::upper_bound(limits.begin(), limits.end(), value);
  const auto band = above == limits.begin() ? 0 : above - limits.begin() - 1;
  return std::min(colours.size() - 1, static_cast<std::size_t>(band));
}

ColourBands colour_bands(double low, double high, bool difference) {
  if (!(low <= high)) low = high = 0;
  if (difference) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  const double least = std::max(1e-12, 1e-9 * std::max(std::abs(low), std::abs(high)));
  if (high - low < least) low -= least, high += least;
  const Axis axis = round_axis(low, high, false);
  ColourBands bands;
  for (const Tick& tick : axis.ticks)
    if (!tick.label.empty()) bands.labelled.push_back(tick.at);
  const double step = bands.labelled.size() > 1 ? bands.labelled[1] - bands.labelled[0] : axis.to - axis.from;
  const double part = step / std::max(1.0, std::round(12 * step / (axis.to - axis.from)));
  const auto count = static_cast<std::size_t>(std::lround((axis.to - axis.from) / part));
  for (std::size_t k = 0; k <= count; ++k)
    bands.limits.push_back(axis.from + static_cast<double>(k) * (axis.to - axis.from) / static_cast<double>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    bands.colours.push_back(difference ? diverging_colour(share) : sequential_colour(share));
  }
  return bands;
}

std::string legend_svg(const ColourBands& bands, const LegendText& text, double width) {
  constexpr double margin = 24, top = 18, thick = 9;
  const double low = bands.limits.front(), span = bands.limits.back() - low;
  const auto place = [&](double value) { return margin + (value - low) / span * (width - 2 * margin); };
  const bool pressure = text.unit == "kPa" && text.pressure_per_head > 0;
  std::ostringstream out;
  out << "<svg class=\"legend\" viewBox=\"0 0 " << width << " 42\" font-size=\"11\" fill=\"currentColor\">"
      << both_units("x=\"" + number_text(margin) + "\" y=\"12\"", named(text.quantity, text.unit),
                    pressure ? named(text.quantity + " as head of water", "m") : "");
  for (std::size_t k = 0; k < bands.colours.size(); ++k)
    out << "<rect x=\"" << place(bands.limits[k]) << "\" y=\"" << top << "\" width=\""
        << place(bands.limits[k + 1]) - place(bands.limits[k]) + 0.2 << "\" height=\"" << thick << "\" fill=\""
        << bands.colours[k] << "\"/>";
  for (const double value : bands.labelled) {
    std::ostringstream at;
    at << "x=\"" << place(value) << "\" y=\"39\" text-anchor=\"middle\"";
    const double rounded = std::abs(value) < 1e-9 * span ? 0 : value;
    out << both_units(at.str(), html(number_text(rounded)),
                      pressure ? html(number_text(rounded / text.pressure_per_head)) : "");
  }
  out << "</svg>";
  return out.str();
}

}  // namespace wetfront::reports
