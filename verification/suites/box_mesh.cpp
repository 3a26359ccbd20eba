#include "verification/suites/box_mesh.h"

#include <utility>

namespace wetfront::verification {
namespace {

/// Node numbers of a regular grid: the first axis runs fastest.
struct Grid {
  int dim;
  std::array<int, 3> cells;
  int points(int axis) const { return axis < dim ? cells[axis] + 1 : 1; }
  int node(int i, int j, int k) const { return i + points(0) * (j + points(1) * k); }
};

/// The faces of a grid on one end of an axis, counter-clockwise in the other two.
std::vector<int> end_faces(const Grid& grid, int axis, bool far) {
  std::array<int, 3> at{};
  at[axis] = far ? grid.cells[axis] : 0;
  std::vector<int> faces;
  const auto node = [&](const std::array<int, 3>& p) { return grid.node(p[0], p[1], p[2]); };
  if (grid.dim == 1) return {node(at)};
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  const int rows = grid.dim == 3 ? grid.cells[b] : 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < grid.cells[a]; ++i) {
      auto corner = at;
      corner[a] = i, corner[b] = grid.dim == 3 ? j : 0;
      for (auto [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        if (grid.dim == 2 && dj == 1) continue;
        auto p = corner;
        p[a] += di, p[b] += dj;
        faces.push_back(node(p));
      }
    }
  return faces;
}

}  // namespace

meshes::Mesh box_mesh(int dim, const std::array<double, 3>& size, const std::array<int, 3>& cells) {
  const Grid grid{dim, cells};
  meshes::Mesh mesh;
  mesh.dim = dim;
  for (int k = 0; k < grid.points(2); ++k)
    for (int j = 0; j < grid.points(1); ++j)
      for (int i = 0; i < grid.points(0); ++i) {
        const std::array<int, 3> index{i, j, k};
        meshes::Point at{};
        for (int axis = 0; axis < dim; ++axis) at[axis] = size[axis] * index[axis] / cells[axis];
        mesh.nodes.push_back(at);
      }
  const int layers = dim == 3 ? cells[2] : 1, rows = dim >= 2 ? cells[1] : 1;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < cells[0]; ++i)
        for (int dk = 0; dk < (dim == 3 ? 2 : 1); ++dk)
          for (auto [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            if (dim == 1 && dj == 1) continue;
            mesh.cells.push_back(grid.node(i + di, j + dj, k + dk));
          }
  mesh.region.assign(static_cast<std::size_t>(cells[0]) * rows * layers, 0);
  mesh.region_names = {"soil"};
  const int up = meshes::up_axis(dim);
  mesh.sides = {{"base", end_faces(grid, up, false)}, {"top", end_faces(grid, up, true)}};
  if (dim >= 2) {
    mesh.sides.push_back({"left", end_faces(grid, 0, false)});
    mesh.sides.push_back({"right", end_faces(grid, 0, true)});
  }
  if (dim == 3) {
    mesh.sides.push_back({"front", end_faces(grid, 1, false)});
    mesh.sides.push_back({"back", end_faces(grid, 1, true)});
  }
  return mesh;
}

void name_regions(meshes::Mesh& mesh, std::vector<std::string> names,
                  const std::function<int(const meshes::Point&)>& region_at) {
  mesh.region_names = std::move(names);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) mesh.region[c] = region_at(mesh.cell_centre(c));
}

void split_side(meshes::Mesh& mesh, const std::string& side, const std::string& name,
                const std::function<bool(const meshes::Point&)>& part) {
  meshes::Side chosen{name, {}}, rest{side, {}};
  const int nodes = meshes::nodes_per_face(mesh.dim);
  const std::vector<int> faces = mesh.side(side).faces;
  for (std::size_t f = 0; f < faces.size(); f += nodes) {
    meshes::Point centre{};
    for (int n = 0; n < nodes; ++n)
      for (int axis = 0; axis < 3; ++axis) centre[axis] += mesh.nodes[faces[f + n]][axis] / nodes;
    auto& target = (part(centre) ? chosen : rest).faces;
    target.insert(target.end(), faces.begin() + f, faces.begin() + f + nodes);
  }
  for (auto& known : mesh.sides)
    if (known.name == side) known = rest;
  mesh.sides.push_back(chosen);
}

}  // namespace wetfront::verification
