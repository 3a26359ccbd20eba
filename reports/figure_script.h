#pragma once

#include "reports/axes.h"
#include "reports/record.h"

#include <string>

namespace wetfront::reports {

/// Where a figure's parts lie, in the pixels of its SVG. The plot itself has the same size in every figure.
struct FigureLayout {
  static constexpr double width = 560, plot_width = 462, plot_height = 300, left = 78;
  std::vector<std::string> title_lines, note_lines;
  std::size_t legend_columns = 1, legend_rows = 1;
  double top = 0;  ///< upper edge of the plot
  double height = 0;

  double right() const { return left + plot_width; }
  double bottom() const { return top + plot_height; }
};

FigureLayout lay_out(const Figure& figure);

/// The gnuplot script that draws `<id>.svg` from `<id>.csv` in the working folder. It is kept beside them: to restyle a
/// figure, edit and run it.
std::string figure_script(const Figure& figure, const FigureAxes& axes);

}  // namespace wetfront::reports
