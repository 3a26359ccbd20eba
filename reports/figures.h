#pragma once

#include "reports/axes.h"
#include "reports/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::reports {

struct DrawnFigure {
  FigureAxes axes;
  std::string svg;  ///< an <svg> element to put into a page
};

/// Writes `<id>.csv`, `<id>.gp` and `<id>.svg` of every figure into `folder` and returns the drawings. The CSV files
/// are in place before anything is drawn. Throws std::runtime_error on a bad id, a missing gnuplot or a failing write.
std::vector<DrawnFigure> write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder);

}  // namespace wetfront::reports
