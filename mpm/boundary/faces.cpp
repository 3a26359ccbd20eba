#include "mpm/boundary/faces.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::mpm {

template <int dim>
std::array<int, face_nodes<dim>> local_face(int face) {
  if constexpr (dim == 2) {
    return {face, (face + 1) % 4};
  } else {
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    return faces[static_cast<std::size_t>(face)];
  }
}

template <int dim>
std::array<Vector<dim>, face_nodes<dim>> Faces<dim>::integrals(const Grid<dim>& grid, std::size_t cell, int face) {
  const auto local = local_face<dim>(face);
  const auto corner = [&](int i) { return grid.node(grid.cell_nodes_of(cell)[local[index(i)]]); };
  std::array<Vector<dim>, face_nodes<dim>> out{};
  if constexpr (dim == 2) {
    const auto &a = corner(0), &b = corner(1);
    out[0] = out[1] = {0.5 * (b[1] - a[1]), -0.5 * (b[0] - a[0])};
  } else {
    const double gauss = 1 / std::sqrt(3.0);
    for (double u : {-gauss, gauss})
      for (double v : {-gauss, gauss}) {
        Stencil<2> s;
        reference_stencil<2>({u, v}, s);
        Vector<3> du{}, dv{};
        for (int i = 0; i < 4; ++i)
          for (int a = 0; a < 3; ++a) {
            du[a] += s.gradient[i][0] * corner(i)[a];
            dv[a] += s.gradient[i][1] * corner(i)[a];
          }
        for (int i = 0; i < 4; ++i)
          for (int a = 0; a < 3; ++a)
            out[i][a] += s.value[i] * (du[(a + 1) % 3] * dv[(a + 2) % 3] - du[(a + 2) % 3] * dv[(a + 1) % 3]);
      }
  }
  return out;
}

template <int dim>
Faces<dim>::Faces(const Grid<dim>& grid, const meshes::Mesh& mesh)
    : neighbour_(grid.cell_count() * cell_faces<dim>, -1),
      side_(neighbour_.size(), -1),
      border_node_(grid.node_count(), 0) {
  using Key = std::array<int, face_nodes<dim>>;
  std::map<Key, std::size_t> open;  // faces met once so far
  const auto key_of = [](const int* nodes) {
    Key key;
    std::copy_n(nodes, face_nodes<dim>, key.begin());
    std::sort(key.begin(), key.end());
    return key;
  };
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int face = 0; face < cell_faces<dim>; ++face) {
      Key nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = grid.cell_nodes_of(cell)[local_face<dim>(face)[i]];
      const std::size_t here = cell * cell_faces<dim> + index(face);
      const auto [found, fresh] = open.try_emplace(key_of(nodes.data()), here);
      if (fresh) continue;
      neighbour_[here] = static_cast<int>(found->second / cell_faces<dim>);
      neighbour_[found->second] = static_cast<int>(cell);
      open.erase(found);
    }
  for (const auto& [key, here] : open)
    for (int node : key) border_node_[static_cast<std::size_t>(node)] = 1;
  for (std::size_t s = 0; s < mesh.sides.size(); ++s)
    for (std::size_t f = 0; f + face_nodes<dim> <= mesh.sides[s].faces.size(); f += face_nodes<dim>) {
      const auto found = open.find(key_of(&mesh.sides[s].faces[f]));
      if (found != open.end()) side_[found->second] = static_cast<int>(s);
    }
}

template std::array<int, 2> local_face<2>(int);
template std::array<int, 4> local_face<3>(int);
template class Faces<2>;
template class Faces<3>;

}  // namespace wetfront::mpm
