#pragma once

#include "meshes/mesh.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <map>
#include <vector>

// Our mesh as a deal.II triangulation. For space.cpp only: deal.II's headers take 20 s to compile.
namespace wetfront::fem_reference {

template <int dim>
meshes::Point to_point(const dealii::Point<dim>& p) {
  meshes::Point result{};
  for (int axis = 0; axis < dim; ++axis) result[axis] = p[axis];
  return result;
}

template <int dim>
dealii::Point<dim> to_dealii(const meshes::Point& p) {
  dealii::Point<dim> result;
  for (int axis = 0; axis < dim; ++axis) result[axis] = p[axis];
  return result;
}

/// Boundary id of a mesh side; 0 is no side. Refined faces inherit it.
inline unsigned int boundary_id(const meshes::Mesh& mesh, const std::string& side) {
  return static_cast<unsigned int>(1 + (&mesh.side(side) - mesh.sides.data()));
}

/// Found by the face's set of vertices, which are the mesh's nodes.
template <int dim>
void set_boundary_ids(const meshes::Mesh& mesh, dealii::Triangulation<dim>& triangulation) {
  const int n = meshes::nodes_per_face(dim);
  std::map<std::vector<unsigned int>, unsigned int> side_of;
  for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
    const auto& faces = mesh.sides[s].faces;
    for (std::size_t f = 0; f + n <= faces.size(); f += n) {
      std::vector<unsigned int> key(faces.begin() + f, faces.begin() + f + n);
      std::sort(key.begin(), key.end());
      side_of[key] = static_cast<unsigned int>(s + 1);
    }
  }
  for (const auto& cell : triangulation.active_cell_iterators()) {
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary()) continue;
      std::vector<unsigned int> key;
      for (int v = 0; v < n; ++v) key.push_back(face->vertex_index(v));
      std::sort(key.begin(), key.end());
      const auto found = side_of.find(key);
      face->set_boundary_id(found == side_of.end() ? 0 : found->second);
    }
  }
}

/// Coarse cells and vertices keep the mesh's numbers.
template <int dim>
void triangulate(const meshes::Mesh& mesh, dealii::Triangulation<dim>& triangulation) {
  std::vector<dealii::Point<dim>> vertices;
  for (const meshes::Point& node : mesh.nodes) vertices.push_back(to_dealii<dim>(node));
  std::vector<dealii::CellData<dim>> cells(mesh.cell_count());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto nodes = mesh.cell(c);
    std::copy(nodes.begin(), nodes.end(), cells[c].vertices.begin());
    if constexpr (dim > 1) {  // gmsh counts around a quadrilateral, deal.II row by row
      for (std::size_t i = 2; i < nodes.size(); i += 4) std::swap(cells[c].vertices[i], cells[c].vertices[i + 1]);
    }
    cells[c].material_id = mesh.region[c];
  }
  if constexpr (dim > 1) dealii::GridTools::consistently_order_cells(cells);
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
  set_boundary_ids(mesh, triangulation);
}

}  // namespace wetfront::fem_reference
