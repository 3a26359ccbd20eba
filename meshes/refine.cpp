#include "meshes/refine.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace wetfront::meshes {
namespace {

/// Corners of a line, quadrilateral or hexahedron in gmsh's order as bits, one per direction, and back.
constexpr std::array<unsigned, 8> corner_bits{0, 1, 3, 2, 4, 5, 7, 6};

/// Cuts cells and faces into 2^dim parts, adding the middle of each edge, face and cell once, whoever asks for it.
class Cutter {
 public:
  explicit Cutter(Mesh& mesh) : mesh_(mesh) {}

  /// Appends the parts of a cell or face with these corners.
  void cut(std::span<const int> corners, std::vector<int>& into) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < corners.size(); ++j) into.push_back(middle(corners, i, j));
    }
  }

 private:
  // The middle of the edge, face or cell of which corners i and j are opposite ends.
  int middle(std::span<const int> corners, std::size_t i, std::size_t j) {
    if (i == j) return corners[i];
    const unsigned fixed = ~(corner_bits[i] ^ corner_bits[j]);
    Point sum{};
    int count = 0, lowest = corners[i];
    std::size_t lowest_corner = i;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if ((corner_bits[k] & fixed) != (corner_bits[i] & fixed)) continue;
      for (int axis = 0; axis < 3; ++axis) sum[axis] += mesh_.nodes[corners[k]][axis];
      ++count;
      if (corners[k] < lowest) lowest = corners[lowest_corner = k];
    }
    // Two opposite nodes name an edge, face or cell.
    const unsigned opposite = corner_bits[lowest_corner] ^ ~fixed;
    const auto end = std::find(corner_bits.begin(), corner_bits.end(), opposite) - corner_bits.begin();
    const auto [entry, fresh] = index_.emplace(std::pair{lowest, corners[end]}, static_cast<int>(mesh_.nodes.size()));
    if (fresh) mesh_.nodes.push_back({sum[0] / count, sum[1] / count, sum[2] / count});
    return entry->second;
  }

  Mesh& mesh_;
  std::map<std::pair<int, int>, int> index_;
};

}  // namespace

Mesh refined(const Mesh& mesh) {
  Mesh fine = mesh;
  fine.cells.clear();
  fine.region.clear();
  Cutter cutter(fine);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    cutter.cut(mesh.cell(c), fine.cells);
    fine.region.insert(fine.region.end(), std::size_t{1} << mesh.dim, mesh.region[c]);
  }
  const std::size_t corners = nodes_per_face(mesh.dim);
  for (std::size_t s = 0; s < mesh.sides.size(); ++s) {
    fine.sides[s].faces.clear();
    const std::span<const int> faces(mesh.sides[s].faces);
    for (std::size_t f = 0; f < faces.size(); f += corners) cutter.cut(faces.subspan(f, corners), fine.sides[s].faces);
  }
  return fine;
}

}  // namespace wetfront::meshes
