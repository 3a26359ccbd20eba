#pragma once

#include "meshes/mesh.h"

#include <filesystem>
#include <vector>

namespace wetfront::verification {

/// A pressure field on a mesh of its own.
struct FormerField {
  meshes::Mesh mesh;             ///< nodes and cells
  std::vector<double> pressure;  ///< Pa, one per node

  /// At the nodes of another mesh: interpolated inside, that of the nearest node outside. A line serves a mesh of more
  /// dimensions by its elevations, and a strip serves a line by its left edge.
  std::vector<double> at_nodes(const meshes::Mesh& other) const;
};

/// Reads "pore_pressure [Pa]" from a field file as wetfront writes them (VTU, version 1.0, inline base64). Throws
/// std::runtime_error saying what is wrong with another.
FormerField read_former_field(const std::filesystem::path& file);

}  // namespace wetfront::verification
