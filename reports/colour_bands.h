#pragma once

#include <string>
#include <vector>

namespace wetfront::reports {

/// Values in bands of one colour each, between round limits.
struct ColourBands {
  std::vector<double> limits;        ///< ascending, one more than colours
  std::vector<std::string> colours;  ///< "#rrggbb"
  std::vector<double> labelled;      ///< the limits that a legend names

  /// The band a value lies in; what lies outside goes to the nearest.
  std::size_t band_of(double value) const;
};

/// About twelve bands over [low, high], widened to round limits; `difference`: symmetric to zero, from blue to red.
ColourBands colour_bands(double low, double high, bool difference);

/// What a legend says beside its colours.
struct LegendText {
  std::string quantity, unit;
  double pressure_per_head = 0;  ///< kPa per metre: pressures in kPa are told in metres of water, too; 0: not
};

/// The legend as a drawing of its own.
std::string legend_svg(const ColourBands& bands, const LegendText& text, double width);

}  // namespace wetfront::reports
