#pragma once

#include "meshes/mesh.h"

/// Rectangles of squares, for the tests of mpm/coupling.
namespace wetfront::mpm::test {

/// nx x ny cells, node j (nx + 1) + i at (i, j); sides base, top, left, right.
inline meshes::Mesh box(double width, double height, int nx, int ny) {
  meshes::Mesh mesh;
  const auto node = [nx](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.nodes.push_back({i * width / nx, j * height / ny, 0});
  meshes::Side base{"base", {}}, top{"top", {}}, left{"left", {}}, right{"right", {}};
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      for (int n : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}) mesh.cells.push_back(n);
      mesh.region.push_back(0);
    }
  for (int i = 0; i < nx; ++i) {
    for (int n : {node(i, 0), node(i + 1, 0)}) base.faces.push_back(n);
    for (int n : {node(i + 1, ny), node(i, ny)}) top.faces.push_back(n);
  }
  for (int j = 0; j < ny; ++j) {
    for (int n : {node(0, j + 1), node(0, j)}) left.faces.push_back(n);
    for (int n : {node(nx, j), node(nx, j + 1)}) right.faces.push_back(n);
  }
  mesh.region_names = {"soil"};
  mesh.sides = {base, top, left, right};
  return mesh;
}

}  // namespace wetfront::mpm::test
