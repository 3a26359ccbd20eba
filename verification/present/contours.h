#pragma once

#include "meshes/mesh.h"
#include "reports/record.h"

#include <vector>

namespace wetfront::verification {

/// The line along which a nodal field of a two-dimensional mesh has a value, as one series of x and y [m]; its parts
/// are separated by NaN. Straight in every cell (marching squares, saddles by the cell's mean).
reports::Series contour(const meshes::Mesh& mesh, const std::vector<double>& nodal, double value);

/// The outline of the mesh, and the lines between its regions (empty where there is one).
reports::Series outline(const meshes::Mesh& mesh);
reports::Series region_boundaries(const meshes::Mesh& mesh);

/// About `count` round values strictly between two others.
std::vector<double> round_levels(double low, double high, int count);

}  // namespace wetfront::verification
