#pragma once

#include <array>
#include <string>
#include <vector>

/// gmsh scripts of ground made of blocks: transfinite, so that every inner boundary is followed by the cells. Sides are
/// "base", "top", "left", "right", in space also "front" and "back"; the only region is "soil".
namespace wetfront::meshes {

/// Elevations [m], ascending, and the number of cells between them: a line with sides "base" and "top".
std::string blocks_of_line(const std::vector<double>& elevation, const std::vector<int>& cells);

/// Block (i, j) lies between the verticals x[i], x[i+1] and the lines j, j+1, counted from the base up.
struct PlaneBlocks {
  std::vector<double> x;                  ///< m, ascending
  std::vector<std::vector<double>> line;  ///< line[j][i]: elevation of line j at x[i] [m]
  std::vector<int> cells_along;           ///< between x[i] and x[i+1]
  std::vector<int> cells_over;            ///< between lines j and j+1
};
std::string blocks_in_plane(const PlaneBlocks& blocks);

/// Planes across x, y and z [m], ascending, and the number of cells between them; z is up, "front" is the least y.
struct SpaceBlocks {
  std::array<std::vector<double>, 3> plane;
  std::array<std::vector<int>, 3> cells;
};
std::string blocks_in_space(const SpaceBlocks& blocks);

}  // namespace wetfront::meshes
