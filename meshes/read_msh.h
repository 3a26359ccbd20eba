#pragma once

#include "meshes/mesh.h"

#include <filesystem>

namespace wetfront::meshes {

/// Reads a gmsh mesh (ASCII, format 4.1 or 2.2). Its dimension is that of its highest-dimensional cells;
/// regions and sides are its named physical groups. Only lines, quadrilaterals and hexahedra are cells here.
/// Throws std::runtime_error with `file:line:column: problem (why). suggestion`.
Mesh read_msh(const std::filesystem::path& path);

}  // namespace wetfront::meshes
