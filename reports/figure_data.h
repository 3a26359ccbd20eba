#pragma once

#include "reports/axes.h"
#include "reports/record.h"

#include <string>

namespace wetfront::reports {

/// The JSON that page.js reads to answer the pointer: the plot's rectangle in the SVG, both axes, every series.
/// Safe inside a <script> element. Values carry 7 significant digits; the CSV carries all.
std::string figure_data(const Figure& figure, const FigureAxes& axes);

}  // namespace wetfront::reports
