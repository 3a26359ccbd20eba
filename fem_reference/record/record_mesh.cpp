#include "fem_reference/record/record_mesh.h"

#include "meshes/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wetfront::fem_reference {
namespace {

using meshes::Point;

/// Corners of a cell or face in gmsh's order as bits, one per direction.
constexpr std::array<unsigned, 8> gmsh_bits{0, 1, 3, 2, 4, 5, 7, 6};

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Volume of the parallelepiped that a cell's edges span at a corner: 2^dim times the corner's lumped mass.
double corner_volume(const meshes::Mesh& mesh, std::span<const int> cell, int corner) {
  std::array<Point, 3> edge{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  for (int axis = 0; axis < mesh.dim; ++axis) {
    const unsigned far = gmsh_bits[corner] ^ (1U << axis);
    const auto end = std::find(gmsh_bits.begin(), gmsh_bits.end(), far) - gmsh_bits.begin();
    edge[axis] = minus(mesh.nodes[cell[end]], mesh.nodes[cell[corner]]);
  }
  // In one dimension the coordinate is the first, and the other two edges above are unit vectors.
  return std::abs(dot(edge[0], cross(edge[1], edge[2])));
}

/// Integral of each corner's shape function times the normal over a face; the sign of the normal is open.
std::vector<Point> corner_areas(const meshes::Mesh& mesh, std::span<const int> face) {
  const auto at = [&](int i) { return mesh.nodes[face[i]]; };
  if (mesh.dim == 1) return {Point{1, 0, 0}};
  if (mesh.dim == 2) {
    const Point along = minus(at(1), at(0)), half{0.5 * along[1], -0.5 * along[0], 0};
    return {half, half};
  }
  std::vector<Point> area(4, Point{});
  constexpr double gauss[2] = {0.21132486540518713, 0.78867513459481287};  // (1 -+ 1/sqrt 3) / 2
  for (const double x : gauss) {
    for (const double y : gauss) {
      Point along_x{}, along_y{};
      for (int axis = 0; axis < 3; ++axis) {
        along_x[axis] = (1 - y) * (at(1)[axis] - at(0)[axis]) + y * (at(2)[axis] - at(3)[axis]);
        along_y[axis] = (1 - x) * (at(3)[axis] - at(0)[axis]) + x * (at(2)[axis] - at(1)[axis]);
      }
      const Point normal = cross(along_x, along_y);
      const double shape[4] = {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
      for (int i = 0; i < 4; ++i) {
        for (int axis = 0; axis < 3; ++axis) area[i][axis] += 0.25 * shape[i] * normal[axis];
      }
    }
  }
  return area;
}

}  // namespace

RecordMesh::RecordMesh(const RichardsProblem& problem, const Discretisation& space)
    : problem_(problem), mesh_(problem.mesh), levels_(problem.adaptivity ? problem.adaptivity->levels : 0) {
  size_ = 1 << levels_;
  for (int level = 0; level < levels_; ++level) {
    mesh_ = meshes::refined(mesh_);
    parts_ <<= mesh_.dim;
  }
  find_shares();
  place_cells(space);
}

void RecordMesh::find_shares() {
  std::map<std::pair<int, int>, double> volume;
  const int corners = meshes::nodes_per_cell(mesh_.dim);
  for (std::size_t c = 0; c < mesh_.cell_count(); ++c) {
    const auto cell = mesh_.cell(c);
    for (int i = 0; i < corners; ++i) {
      volume[{cell[i], mesh_.region[c]}] += corner_volume(mesh_, cell, i) / corners;
    }
  }
  for (const auto& [key, share] : volume) shares_.push_back({key.first, key.second, share});
}

// Part i of a cell lies at its corner i (meshes/refine.h), so the digits of a part's number say where it is.
void RecordMesh::place_cells(const Discretisation& space) {
  const int dim = mesh_.dim, corners = 1 << dim;
  cell_at_.resize(mesh_.cell_count());
  corner_.resize(problem_.mesh.cell_count() * corners);
  for (std::size_t m = 0; m < problem_.mesh.cell_count(); ++m) {
    const auto nodes = problem_.mesh.cell(m);
    for (int d = 0; d < corners; ++d) {
      const auto place = std::find(nodes.begin(), nodes.end(), space.mesh_corner[m * corners + d]) - nodes.begin();
      corner_[m * corners + place] = static_cast<unsigned>(d);
    }
  }
  for (std::size_t c = 0; c < cell_at_.size(); ++c) {
    const std::size_t m = c / parts_;
    std::size_t part = c % parts_, lattice = 0;
    for (std::size_t step = 1; step < static_cast<std::size_t>(size_);
         step *= 2, part /= corners) {  // last halving first
      const unsigned bits = corner_[m * corners + part % corners];
      std::size_t stride = step;
      for (int axis = 0; axis < dim; ++axis, stride *= size_) lattice += (bits >> axis & 1) * stride;
    }
    cell_at_[m * parts_ + lattice] = static_cast<int>(c);
  }
}

/// Calls visit(cell of mesh(), cell of the discretisation, values at the latter's corners, place of the former in the
/// latter as a lower corner and a size in its unit cell).
template <class Visit>
void RecordMesh::visit_parts(const Discretisation& space, std::span<const double> field, Visit visit) const {
  const int dim = space.dim, corners = space.corners(), n = space.dofs_per_cell;
  for (int k = 0; k < space.cell_count; ++k) {
    const Box& box = space.box[k];
    std::array<double, 8> value{};
    const double* shape = space.corner_shape_of(k);
    for (int v = 0; v < corners; ++v) {
      for (int a = 0; a < n; ++a) value[v] += shape[v * n + a] * field[space.dofs_of(k)[a]];
    }
    const int width = size_ >> box.level;
    int parts = 1;
    for (int axis = 0; axis < dim; ++axis) parts *= width;
    for (int part = 0; part < parts; ++part) {
      std::array<double, 3> unit{};
      std::size_t lattice = 0, stride = 1;
      for (int axis = 0, rest = part; axis < dim; ++axis, rest /= width, stride *= size_) {
        unit[axis] = static_cast<double>(rest % width) / width;
        lattice += stride * (box.low[axis] + rest % width);
      }
      visit(cell_at_[box.mesh_cell * parts_ + lattice], k, value, unit, 1.0 / width);
    }
  }
}

namespace {

/// What a rank says of places that only others know: their values are larger.
constexpr double elsewhere = -std::numeric_limits<double>::infinity();

double multilinear(const std::array<double, 8>& value, int dim, const std::array<double, 3>& unit) {
  double sum = 0;
  for (unsigned v = 0; v < 1U << dim; ++v) {
    double weight = 1;
    for (int axis = 0; axis < dim; ++axis) weight *= (v >> axis & 1) != 0 ? unit[axis] : 1 - unit[axis];
    if (weight != 0) sum += weight * value[v];
  }
  return sum;
}

}  // namespace

std::vector<double> RecordMesh::at_nodes(const Discretisation& space, std::span<const double> field) const {
  std::vector<double> result(mesh_.node_count(), elsewhere);
  const int dim = space.dim, corners = space.corners();
  visit_parts(space, field, [&](int part, int, const auto& value, const auto& low, double size) {
    const std::size_t first = static_cast<std::size_t>(mesh_cell(part)) * corners;
    for (int i = 0; i < corners; ++i) {
      std::array<double, 3> unit = low;
      for (int axis = 0; axis < dim; ++axis) unit[axis] += size * (corner_[first + i] >> axis & 1);
      result[mesh_.cell(part)[i]] = multilinear(value, dim, unit);
    }
  });
  space.ranks.max(result);
  return result;
}

std::vector<double> RecordMesh::at_cells(const Discretisation& space, std::span<const double> field) const {
  std::vector<double> result(mesh_.cell_count(), elsewhere);
  const int dim = space.dim, n = space.dofs_per_cell;
  visit_parts(space, field, [&](int part, int cell, const auto& value, const auto& low, double size) {
    if (levels_ == 0) {  // of any degree
      result[part] = 0;
      for (int a = 0; a < n; ++a) result[part] += space.centre_shape_of(cell)[a] * field[space.dofs_of(cell)[a]];
      return;
    }
    std::array<double, 3> unit = low;
    for (int axis = 0; axis < dim; ++axis) unit[axis] += 0.5 * size;
    result[part] = multilinear(value, dim, unit);
  });
  space.ranks.max(result);
  return result;
}

std::vector<double> RecordMesh::outward(const meshes::Side& side) const {
  const meshes::Mesh& mesh = problem_.mesh;
  const int corners = meshes::nodes_per_face(mesh.dim);
  std::map<int, std::vector<std::size_t>> cells_at;  // of the side's nodes
  for (int node : side.faces) cells_at[node];
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    for (int node : mesh.cell(c)) {
      if (const auto found = cells_at.find(node); found != cells_at.end()) found->second.push_back(c);
    }
  }
  std::vector<double> sign;
  for (std::size_t f = 0; f < side.faces.size(); f += corners) {
    const std::span<const int> face(&side.faces[f], corners);
    const auto has_face = [&](std::size_t c) {
      const auto cell = mesh.cell(c);
      return std::all_of(face.begin(), face.end(),
                         [&](int node) { return std::find(cell.begin(), cell.end(), node) != cell.end(); });
    };
    const auto& candidates = cells_at[face[0]];
    const auto owner = std::find_if(candidates.begin(), candidates.end(), has_face);
    const Point out = minus(mesh.nodes[face[0]], mesh.cell_centre(*owner));
    Point area{};
    for (const Point& share : corner_areas(mesh, face)) area = minus(area, share);
    sign.push_back(dot(area, out) < 0 ? 1 : -1);
  }
  return sign;
}

std::vector<double> RecordMesh::catchment() const {
  std::vector<double> caught(mesh_.node_count(), 0.0);
  const std::size_t corners = meshes::nodes_per_face(mesh_.dim);
  for (const BoundaryCondition& condition : problem_.boundary) {
    const bool flux = std::holds_alternative<FluxSide>(condition);
    if (!flux && !std::holds_alternative<RainSide>(condition) && !std::holds_alternative<WaterLevelSide>(condition)) {
      continue;
    }
    const std::string& side = std::visit([](const auto& c) -> const std::string& { return c.side; }, condition);
    const std::vector<int>& faces = mesh_.side(side).faces;
    const std::vector<double> sign = outward(problem_.mesh.side(side));
    const std::size_t parts = faces.size() / (sign.size() * corners);
    for (std::size_t f = 0; f * corners < faces.size(); ++f) {
      const std::span<const int> face(&faces[f * corners], corners);
      const std::vector<Point> area = corner_areas(mesh_, face);
      for (std::size_t i = 0; i < corners; ++i) {
        const double up = -sign[f / parts] * dot(area[i], problem_.gravity_direction);
        caught[face[i]] += flux ? std::sqrt(dot(area[i], area[i])) : std::max(0.0, up);
      }
    }
  }
  return caught;
}

}  // namespace wetfront::fem_reference
