#include "meshes/geo_script.h"

#include <array>
#include <cmath>
#include <sstream>

namespace wetfront::meshes {
namespace {

std::ostringstream exact_stream() {
  std::ostringstream out;
  out.precision(17);
  return out;
}

/// Transfinite quadrilateral patch from its corners (counter-clockwise from lower left).
std::string patch_script(const std::array<std::array<double, 2>, 4>& corners, int cells_along, int cells_over) {
  auto out = exact_stream();
  for (int i = 0; i < 4; ++i)
    out << "Point(" << i + 1 << ") = {" << corners[i][0] << ", " << corners[i][1] << ", 0};\n";
  out << "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\n"
      << "Curve Loop(1) = {1, 2, 3, 4};\nPlane Surface(1) = {1};\n"
      << "Transfinite Curve {1, 3} = " << cells_along + 1 << ";\n"
      << "Transfinite Curve {2, 4} = " << cells_over + 1 << ";\n"
      << "Transfinite Surface {1};\nRecombine Surface {1};\n"
      << "Physical Curve(\"base\") = {1};\nPhysical Curve(\"right\") = {2};\n"
      << "Physical Curve(\"top\") = {3};\nPhysical Curve(\"left\") = {4};\nPhysical Surface(\"soil\") = {1};\n";
  return out.str();
}

}  // namespace

std::string line_column_script(double height, int cells) {
  auto out = exact_stream();
  out << "Point(1) = {0, 0, 0};\nPoint(2) = {" << height << ", 0, 0};\nLine(1) = {1, 2};\n"
      << "Transfinite Curve {1} = " << cells + 1 << ";\n"
      << "Physical Point(\"base\") = {1};\nPhysical Point(\"top\") = {2};\nPhysical Curve(\"soil\") = {1};\n";
  return out.str();
}

std::string strip_column_script(double height, double width, int cells) {
  return patch_script({{{0, 0}, {width, 0}, {width, height}, {0, height}}}, 1, cells);
}

std::string slope_script(const SlopeShape& slope) {
  const double rise = slope.length * std::tan(slope.angle);
  return patch_script({{{0, 0}, {slope.length, rise}, {slope.length, rise + slope.thickness}, {0, slope.thickness}}},
                      slope.cells_along, slope.cells_over);
}

}  // namespace wetfront::meshes
