#pragma once

#include "meshes/mesh.h"

#include <string>

namespace wetfront::meshes {

/// Renumbers nodes and cells by position, elevation first.
void renumber_by_position(Mesh& mesh);

/// Runs the program `gmsh` on a script and reads the mesh of dimension `dim` it makes. Nodes and cells are
/// renumbered by position, so that the numbering does not depend on the gmsh version.
/// gmsh stays a separate program: its licence is GPL, and its API loses the names of sides.
/// Throws std::runtime_error with gmsh's own message when it is missing or fails.
Mesh generate(const std::string& script, int dim);

}  // namespace wetfront::meshes
