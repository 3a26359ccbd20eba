#pragma once

#include <string>

/// gmsh scripts of the built-in shapes. Sides are named by what they are to the ground: "base", "top",
/// "left", "right"; the only region is "soil".
namespace wetfront::meshes {

/// A line from elevation 0 to `height` [m] in `cells` equal cells; sides "base" and "top".
std::string line_column_script(double height, int cells);

/// A strip one cell wide [m], `cells` equal cells high.
std::string strip_column_script(double height, double width, int cells);

/// A layer over a straight base rising to the right: horizontal length [m], vertical thickness [m], angle [rad].
struct SlopeShape {
  double length, thickness, angle;
  int cells_along, cells_over;
};
std::string slope_script(const SlopeShape& slope);

}  // namespace wetfront::meshes
