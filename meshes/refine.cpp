#include "meshes/refine.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace wetfront::meshes {
namespace {

/// Adds the middle of each edge once, whichever cells or sides ask for it.
class Middles {
 public:
  explicit Middles(Mesh& mesh) : mesh_(mesh) {}

  int operator()(int a, int b) {
    const auto [entry, fresh] = index_.emplace(std::minmax(a, b), static_cast<int>(mesh_.nodes.size()));
    if (fresh) {
      Point middle;
      for (int axis = 0; axis < 3; ++axis) middle[axis] = 0.5 * (mesh_.nodes[a][axis] + mesh_.nodes[b][axis]);
      mesh_.nodes.push_back(middle);
    }
    return entry->second;
  }

 private:
  Mesh& mesh_;
  std::map<std::pair<int, int>, int> index_;
};

}  // namespace

Mesh refined(const Mesh& mesh) {
  if (mesh.dim > 2) throw std::invalid_argument("refining a mesh is implemented in one and two dimensions");
  Mesh fine = mesh;
  fine.cells.clear();
  fine.region.clear();
  Middles middle(fine);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto n = mesh.cell(c);
    if (mesh.dim == 1) {
      const int m = middle(n[0], n[1]);
      fine.cells.insert(fine.cells.end(), {n[0], m, m, n[1]});
    } else {
      const int e0 = middle(n[0], n[1]), e1 = middle(n[1], n[2]), e2 = middle(n[2], n[3]), e3 = middle(n[3], n[0]);
      const int centre = static_cast<int>(fine.nodes.size());
      fine.nodes.push_back(mesh.cell_centre(c));
      fine.cells.insert(fine.cells.end(), {n[0], e0, centre, e3, e0, n[1], e1, centre,  //
                                           centre, e1, n[2], e2, e3, centre, e2, n[3]});
    }
    fine.region.insert(fine.region.end(), std::size_t{1} << mesh.dim, mesh.region[c]);
  }
  if (mesh.dim == 2)
    for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
      fine.sides[s].faces.clear();
      for (std::size_t f = 0; f < mesh.sides[s].faces.size(); f += 2) {
        const int a = mesh.sides[s].faces[f], b = mesh.sides[s].faces[f + 1], m = middle(a, b);
        fine.sides[s].faces.insert(fine.sides[s].faces.end(), {a, m, m, b});
      }
    }
  return fine;
}

}  // namespace wetfront::meshes
