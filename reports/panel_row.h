#pragma once

#include <string>
#include <vector>

namespace wetfront::reports {

/// A drawing and its legend, each an <svg> element as PlaneDrawing and legend_svg() make them.
struct RowPanel {
  std::string label, drawing, legend;
};

/// The panels side by side as one SVG file on white, for papers; each `width` by `height` pixels, legend and label
/// apart.
std::string in_a_row(const std::vector<RowPanel>& panels, double width, double height);

}  // namespace wetfront::reports
