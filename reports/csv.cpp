#include "reports/csv.h"

#include "reports/escape.h"
#include "reports/number_text.h"

#include <algorithm>

namespace wetfront::reports {

std::string label_with_unit(const std::string& label, const std::string& unit) {
  return label + " [" + (unit.empty() || unit == "1" ? "-" : unit) + "]";
}

std::string figure_csv(const Figure& figure) {
  std::string text;
  std::size_t rows = 0;
  for (const Series& series : figure.series) {
    if (!text.empty()) text += ',';
    const std::string of = series.label.empty() ? "" : series.label + ": ";
    text += csv_cell(of + label_with_unit(figure.x_label, figure.x_unit)) + ',' +
            csv_cell(of + label_with_unit(figure.y_label, figure.y_unit));
    rows = std::max(rows, series.x.size());
  }
  text += '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      const Series& series = figure.series[s];
      if (s > 0) text += ',';
      if (row < series.x.size())
        text += exact_text(series.x[row]) + ',' + exact_text(series.y[row]);
      else
        text += ',';
    }
    text += '\n';
  }
  return text;
}

}  // namespace wetfront::reports
