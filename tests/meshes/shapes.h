#pragma once

#include "meshes/block_script.h"

#include <cmath>

/// The simplest shapes as gmsh scripts of one block.
namespace wetfront::meshes {

inline std::string line_script(double height, int cells) {
  return blocks_of_line({0, height}, {cells});
}

/// One cell wide [m].
inline std::string strip_script(double height, double width, int cells) {
  return blocks_in_plane({{0, width}, {{0, 0}, {height, height}}, {1}, {cells}});
}

/// A layer over a straight base rising to the right: horizontal length [m], vertical thickness [m], angle [rad].
struct SlopeShape {
  double length, thickness, angle;
  int cells_along, cells_over;
};
inline std::string slope_script(const SlopeShape& slope) {
  const double rise = slope.length * std::tan(slope.angle);
  return blocks_in_plane({{0, slope.length},
                          {{0, rise}, {slope.thickness, rise + slope.thickness}},
                          {slope.cells_along},
                          {slope.cells_over}});
}

}  // namespace wetfront::meshes
