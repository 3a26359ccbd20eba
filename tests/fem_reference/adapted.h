#pragma once

#include "fem_reference/space/space.h"
#include "fem_reference/stage/boundary.h"
#include "fem_reference/stage/flow_operator.h"
#include "tests/fem_reference/columns.h"

#include <random>

namespace wetfront::fem_reference::testing {

/// `cells` hexahedra along each edge of the unit cube; sides "base", "top" and "patch", the quarter of the top at the
/// origin.
inline meshes::Mesh block_mesh(int cells) {
  meshes::Mesh mesh;
  mesh.dim = 3;
  const int row = cells + 1, layer = row * row;
  for (int i = 0; i < row * layer; ++i) {
    mesh.nodes.push_back({1.0 * (i % row) / cells, 1.0 * (i / row % row) / cells, 1.0 * (i / layer) / cells});
  }
  mesh.sides = {{"base", {}}, {"top", {}}, {"patch", {}}};
  for (int c = 0; c < cells * cells * cells; ++c) {
    const int x = c % cells, y = c / cells % cells, z = c / (cells * cells);
    const int a = x + y * row + z * layer;
    const int cell[8] = {a,         a + 1,         a + row + 1,         a + row,
                         a + layer, a + layer + 1, a + layer + row + 1, a + layer + row};
    mesh.cells.insert(mesh.cells.end(), cell, cell + 8);
    if (z == 0) mesh.sides[0].faces.insert(mesh.sides[0].faces.end(), cell, cell + 4);
    const bool near = 2 * x < cells && 2 * y < cells;
    if (z == cells - 1) mesh.sides[near ? 2 : 1].faces.insert(mesh.sides[near ? 2 : 1].faces.end(), cell + 4, cell + 8);
  }
  mesh.region.assign(mesh.cells.size() / 8, 0);
  mesh.region_names = {"soil"};
  return mesh;
}

/// Skews a mesh so that no two cells are alike; the planes on which coordinates vanish stay.
inline void distort(meshes::Mesh& mesh) {
  for (meshes::Point& p : mesh.nodes) {
    const meshes::Point q = p;
    for (int axis = 0; axis < mesh.dim; ++axis) {
      p[axis] *= 1 + 0.1 * q[(axis + 1) % mesh.dim] + 0.07 * q[(axis + 2) % mesh.dim] * q[axis];
    }
  }
}

/// Marks at random: about one cell in three to halve, one in three to join.
inline std::vector<Space::Mark> random_marks(const Discretisation& space, std::mt19937& random) {
  std::vector<Space::Mark> marks;
  for (int cell = 0; cell < space.cell_count; ++cell) {
    const auto draw = random() % 3;
    const bool finest = space.box[cell].level == space.levels;
    marks.push_back(draw == 0 && !finest ? Space::Mark::halve : draw == 1 ? Space::Mark::join : Space::Mark::keep);
  }
  return marks;
}

/// The operator on what a space is now.
struct Operator {
  Operator(const RichardsProblem& problem, Discretisation discretisation)
      : space(std::move(discretisation)), boundary(problem, space), flow(problem, space, boundary) {
    boundary.set_time(0);
  }
  Discretisation space;
  Boundary boundary;
  FlowOperator flow;
};

}  // namespace wetfront::fem_reference::testing
