#pragma once

#include "meshes/mesh.h"

#include <cmath>
#include <functional>

/// Plane meshes made by hand, for the tests of mpm/.
namespace wetfront::mpm::test {

/// nx x ny cells of the unit square mapped by `place`; sides "base", "right", "top", "left".
inline meshes::Mesh plane(int nx, int ny, const std::function<meshes::Point(double, double)>& place) {
  meshes::Mesh mesh;
  const auto node = [nx](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.nodes.push_back(place(double(i) / nx, double(j) / ny));
  mesh.sides = {{"base", {}}, {"right", {}}, {"top", {}}, {"left", {}}};
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      for (int k : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}) mesh.cells.push_back(k);
      mesh.region.push_back(0);
    }
  for (int i = 0; i < nx; ++i) {
    for (int k : {node(i, 0), node(i + 1, 0)}) mesh.sides[0].faces.push_back(k);
    for (int k : {node(i + 1, ny), node(i, ny)}) mesh.sides[2].faces.push_back(k);
  }
  for (int j = 0; j < ny; ++j) {
    for (int k : {node(nx, j), node(nx, j + 1)}) mesh.sides[1].faces.push_back(k);
    for (int k : {node(0, j + 1), node(0, j)}) mesh.sides[3].faces.push_back(k);
  }
  mesh.region_names = {"soil"};
  return mesh;
}

inline meshes::Mesh box(double width, double height, int nx, int ny) {
  return plane(nx, ny, [=](double u, double v) { return meshes::Point{u * width, v * height, 0}; });
}

/// A box whose inner nodes are moved by up to a quarter of a cell: skewed cells, no two alike, the border straight.
inline meshes::Mesh crooked_box(double width, double height, int nx, int ny) {
  return plane(nx, ny, [=](double u, double v) {
    const bool inner_u = u > 0 && u<1, inner_v = v> 0 && v < 1;
    const double a = std::sin(37 * u * nx + 91 * v * ny), b = std::cos(53 * u * nx - 29 * v * ny);
    return meshes::Point{(u + (inner_u ? 0.25 * a / nx : 0)) * width, (v + (inner_v ? 0.25 * b / ny : 0)) * height, 0};
  });
}

}  // namespace wetfront::mpm::test
