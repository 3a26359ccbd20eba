#include "reports/panel_row.h"

#include "reports/escape.h"

#include <sstream>

namespace wetfront::reports {

std::string in_a_row(const std::vector<RowPanel>& panels, double width, double height) {
  constexpr double label = 20, legend = 42;
  std::ostringstream out;
  double left = 0;
  // An element of a page becomes a part of the row: it is told where it lies.
  const auto placed = [&](std::string svg, double top, double high) {
    std::ostringstream place;
    place << "<svg x=\"" << left << "\" y=\"" << top << "\" width=\"" << width << "\" height=\"" << high << "\"";
    return svg.replace(0, 4, place.str());
  };
  const double all = width * static_cast<double>(panels.size());
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << all << "\" height=\"" << label + height + legend
      << "\" font-family=\"sans-serif\" color=\"#1a1a1a\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (const RowPanel& panel : panels) {
    out << "<text x=\"" << left + 42 << "\" y=\"14\" font-size=\"12\">" << html(panel.label) << "</text>\n"
        << placed(panel.drawing, label, height) << "\n"
        << placed(panel.legend, label + height, legend) << "\n";
    left += width;
  }
  out << "</svg>\n";
  return out.str();
}

}  // namespace wetfront::reports
