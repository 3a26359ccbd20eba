#include "fem_reference/discretisation.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace wetfront::fem_reference {
namespace {

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

/// Builds the flat arrays from deal.II objects that live only as long as this does.
template <int dim>
class Discretiser {
 public:
  explicit Discretiser(const RichardsProblem& problem)
      : problem_(problem), fe_(problem.degree), mapping_(1), dofs_(triangulation_) {}

  Discretisation run() {
    make_triangulation();
    dofs_.distribute_dofs(fe_);
    number_upwards();
    merge_periodic();
    fill_cells();
    fill_sides();
    for (const Gauge& gauge : problem_.gauges) out_.gauges.push_back(locate(gauge));
    return std::move(out_);
  }

 private:
  // gmsh counts around a quadrilateral, deal.II row by row.
  std::vector<int> dealii_order(std::span<const int> cell) const {
    std::vector<int> v(cell.begin(), cell.end());
    if constexpr (dim > 1) {
      for (std::size_t i = 2; i < v.size(); i += 4) std::swap(v[i], v[i + 1]);
    }
    return v;
  }

  void make_triangulation() {
    const meshes::Mesh& mesh = problem_.mesh;
    std::vector<dealii::Point<dim>> vertices;
    for (const meshes::Point& node : mesh.nodes) vertices.push_back(to_dealii<dim>(node));
    std::vector<dealii::CellData<dim>> cells(mesh.cell_count());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::vector<int> order = dealii_order(mesh.cell(c));
      std::copy(order.begin(), order.end(), cells[c].vertices.begin());
      cells[c].material_id = mesh.region[c];
    }
    if constexpr (dim > 1) dealii::GridTools::consistently_order_cells(cells);
    triangulation_.create_triangulation(vertices, cells, dealii::SubCellData());
    set_boundary_ids();
  }

  // Boundary id = 1 + index of the mesh side; 0 = no side. Found by the face's set of vertices.
  void set_boundary_ids() {
    const int n = meshes::nodes_per_face(dim);
    std::map<std::vector<unsigned int>, unsigned int> side_of;
    for (std::size_t s = 0; s < problem_.mesh.sides.size(); ++s) {
      const auto& faces = problem_.mesh.sides[s].faces;
      for (std::size_t f = 0; f + n <= faces.size(); f += n) {
        std::vector<unsigned int> key(faces.begin() + f, faces.begin() + f + n);
        std::sort(key.begin(), key.end());
        side_of[key] = s + 1;
      }
    }
    for (const auto& cell : triangulation_.active_cell_iterators()) {
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

  // Numbering upwards makes a column, or a strip a few cells wide, a narrow band for the linear solver.
  void number_upwards() {
    out_.dim = dim;
    out_.dof_count = dofs_.n_dofs();
    out_.cell_count = triangulation_.n_active_cells();
    out_.dofs_per_cell = fe_.n_dofs_per_cell();
    std::vector<meshes::Point> position(out_.dof_count);
    std::vector<dealii::types::global_dof_index> local(out_.dofs_per_cell);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(local);
      for (int a = 0; a < out_.dofs_per_cell; ++a) {
        position[local[a]] = to_point(mapping_.transform_unit_to_real_cell(cell, fe_.unit_support_point(a)));
      }
    }
    std::vector<int> order(out_.dof_count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      for (int axis = dim - 1; axis >= 0; --axis) {
        if (position[a][axis] != position[b][axis]) return position[a][axis] < position[b][axis];
      }
      return a < b;
    });
    number_.resize(out_.dof_count);
    out_.position.resize(out_.dof_count);
    for (int i = 0; i < out_.dof_count; ++i) {
      number_[order[i]] = i;
      out_.position[i] = position[order[i]];
    }
  }

  /// Degrees of freedom on a side, as we number them.
  std::vector<int> dofs_on(const std::string& name) const {
    const unsigned int id = 1 + (&problem_.mesh.side(name) - problem_.mesh.sides.data());
    std::set<int> found;
    std::vector<dealii::types::global_dof_index> local(out_.dofs_per_cell);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(local);
      for (unsigned int f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != id) continue;
        for (int a = 0; a < out_.dofs_per_cell; ++a) {
          if (fe_.has_support_on_face(a, f)) found.insert(number_[local[a]]);
        }
      }
    }
    return {found.begin(), found.end()};
  }

  // A periodic pair is one set of unknowns: the partner's get the numbers of the side's.
  void merge_periodic() {
    std::vector<int> same(out_.dof_count);
    std::iota(same.begin(), same.end(), 0);
    for (const BoundaryCondition& condition : problem_.boundary) {
      if (const auto* pair = std::get_if<PeriodicSides>(&condition)) match(*pair, same);
    }
    std::vector<int> compact(out_.dof_count, -1);
    int count = 0;
    for (int i = 0; i < out_.dof_count; ++i) {
      while (same[i] != same[same[i]]) same[i] = same[same[i]];
    }
    for (int i = 0; i < out_.dof_count; ++i) {
      if (same[i] != i) continue;
      out_.position[count] = out_.position[i];
      compact[i] = count++;
    }
    for (int& number : number_) number = compact[same[number]];
    out_.dof_count = count;
    out_.position.resize(count);
  }

  void match(const PeriodicSides& pair, std::vector<int>& same) const {
    const std::vector<int> side = dofs_on(pair.side), partner = dofs_on(pair.partner);
    const auto fail = [&](const char* why) {
      throw std::invalid_argument("periodic sides '" + pair.side + "' and '" + pair.partner + "': " + why);
    };
    if (side.size() != partner.size()) fail("not the same number of nodes");
    meshes::Point shift{};
    for (std::size_t i = 0; i < side.size(); ++i) {
      for (int axis = 0; axis < dim; ++axis) {
        shift[axis] += (out_.position[partner[i]][axis] - out_.position[side[i]][axis]) / side.size();
      }
    }
    double size = 0;
    for (int axis = 0; axis < dim; ++axis) size += std::abs(shift[axis]);
    for (int a : side) {
      const auto found = std::find_if(partner.begin(), partner.end(), [&](int b) {
        double distance = 0;
        for (int axis = 0; axis < dim; ++axis) {
          distance += std::abs(out_.position[b][axis] - out_.position[a][axis] - shift[axis]);
        }
        return distance < 1e-8 * size;  // nodes of a mesh file carry 8 to 16 digits
      });
      if (found == partner.end()) fail("the nodes of one are not those of the other moved by one vector");
      const int low = std::min(root(same, a), root(same, *found)), high = std::max(root(same, a), root(same, *found));
      same[high] = low;
    }
  }

  static int root(const std::vector<int>& same, int i) {
    while (same[i] != i) i = same[i];
    return i;
  }

  void fill_cells() {
    const dealii::QGauss<dim> gauss(problem_.degree + 1);
    const dealii::QGaussLobatto<dim> nodal(problem_.degree + 1);  // points = nodes: the lumped mass
    dealii::FEValues<dim> values(mapping_, fe_, gauss,
                                 dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
    dealii::FEValues<dim> lumped(mapping_, fe_, nodal, dealii::update_values | dealii::update_JxW_values);
    out_.points_per_cell = gauss.size();
    out_.node_dof.assign(problem_.mesh.node_count(), -1);
    out_.initial_head.assign(out_.dof_count, 0);
    std::vector<dealii::types::global_dof_index> local(out_.dofs_per_cell);
    std::map<std::pair<int, int>, double> volume;
    for (const auto& cell : dofs_.active_cell_iterators()) {
      const int soil = cell->material_id();
      out_.cell_soil.push_back(soil);
      out_.mesh_cell.push_back(static_cast<int>(cell->active_cell_index()));
      cell->get_dof_indices(local);
      for (auto dof : local) out_.cell_dofs.push_back(number_[dof]);
      values.reinit(cell);
      lumped.reinit(cell);
      append_points(values);
      for (int a = 0; a < out_.dofs_per_cell; ++a) {
        for (unsigned int q = 0; q < nodal.size(); ++q) {
          volume[{number_[local[a]], soil}] += lumped.shape_value(a, q) * lumped.JxW(q);
        }
      }
      fill_nodes(cell);
    }
    for (const auto& [key, share] : volume) out_.storage.push_back({key.first, key.second, share});
    fill_shapes(gauss);
  }

  void append_points(const dealii::FEValues<dim>& values) {
    for (int q = 0; q < out_.points_per_cell; ++q) {
      out_.weight.push_back(values.JxW(q));
      for (int a = 0; a < out_.dofs_per_cell; ++a) {
        for (int axis = 0; axis < dim; ++axis) out_.gradient.push_back(values.shape_grad(a, q)[axis]);
      }
    }
  }

  template <class Cell>
  void fill_nodes(const Cell& cell) {
    double vertex_head[1 << dim];
    for (unsigned int v = 0; v < cell->n_vertices(); ++v) {
      out_.node_dof[cell->vertex_index(v)] = number_[cell->vertex_dof_index(v, 0)];
      vertex_head[v] = problem_.initial_head[cell->vertex_index(v)];
    }
    const int* dof = out_.cell_dofs.data() + out_.cell_dofs.size() - out_.dofs_per_cell;
    for (int a = 0; a < out_.dofs_per_cell; ++a) {  // the given heads are linear between the mesh nodes
      double head = 0;
      for (unsigned int v = 0; v < cell->n_vertices(); ++v) {
        head += vertex_head[v] * dealii::GeometryInfo<dim>::d_linear_shape_function(fe_.unit_support_point(a), v);
      }
      out_.initial_head[dof[a]] = head;
    }
  }

  void fill_shapes(const dealii::Quadrature<dim>& gauss) {
    for (const auto& point : gauss.get_points()) append_shape(point, out_.shape);
    dealii::Point<dim> centre;
    for (int axis = 0; axis < dim; ++axis) centre[axis] = 0.5;
    append_shape(centre, out_.centre_shape);
  }

  void append_shape(const dealii::Point<dim>& unit, std::vector<double>& into) const {
    for (int a = 0; a < out_.dofs_per_cell; ++a) into.push_back(fe_.shape_value(a, unit));
  }

  void fill_sides() {
    const dealii::QGauss<dim - 1> gauss(problem_.degree + 1);
    dealii::FEFaceValues<dim> values(mapping_, fe_, gauss,
                                     dealii::update_values | dealii::update_JxW_values | dealii::update_normal_vectors);
    std::vector<dealii::types::global_dof_index> local(out_.dofs_per_cell);
    for (const BoundaryCondition& condition : problem_.boundary) {
      const std::string& name = std::visit([](const auto& c) -> const std::string& { return c.side; }, condition);
      const unsigned int id = 1 + (&problem_.mesh.side(name) - problem_.mesh.sides.data());
      std::map<std::pair<int, int>, SideShare> shares;
      for (const auto& cell : dofs_.active_cell_iterators()) {
        cell->get_dof_indices(local);
        for (unsigned int f : cell->face_indices()) {
          if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != id) continue;
          values.reinit(cell, f);
          add_face(values, f, local, cell->material_id(), conductivity_factor(cell), shares);
        }
      }
      out_.sides.emplace_back();
      for (const auto& [key, share] : shares) out_.sides.back().push_back(share);
    }
  }

  template <class Cell>
  double conductivity_factor(const Cell& cell) const {
    return problem_.conductivity_factor.empty() ? 1 : problem_.conductivity_factor[cell->active_cell_index()];
  }

  void add_face(const dealii::FEFaceValues<dim>& values, unsigned int face,
                const std::vector<dealii::types::global_dof_index>& local, int soil, double factor,
                std::map<std::pair<int, int>, SideShare>& shares) const {
    for (int a = 0; a < out_.dofs_per_cell; ++a) {
      if (!fe_.has_support_on_face(a, face)) continue;
      const int dof = number_[local[a]];
      SideShare& share = shares.try_emplace({dof, soil}, SideShare{dof, soil, 0, 0, {}}).first->second;
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
        const double area = values.shape_value(a, q) * values.JxW(q);
        double up = 0;
        for (int axis = 0; axis < dim; ++axis) {
          up -= values.normal_vector(q)[axis] * problem_.gravity_direction[axis];
          share.normal_area[axis] += factor * area * values.normal_vector(q)[axis];
        }
        share.area += area;
        share.horizontal_area += area * up;
      }
    }
  }

  Place locate(const Gauge& gauge) const {
    constexpr double slack = 1e-9;  // of the unit cell: a gauge on a face belongs to either neighbour
    const dealii::Point<dim> point = to_dealii<dim>(gauge.position);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      if (cell->center().distance(point) > cell->diameter()) continue;
      try {
        const dealii::Point<dim> unit = mapping_.transform_real_to_unit_cell(cell, point);
        if (!dealii::GeometryInfo<dim>::is_inside_unit_cell(unit, slack)) continue;
        Place place{static_cast<int>(cell->active_cell_index()), {}};
        append_shape(unit, place.shape);
        return place;
      } catch (const typename dealii::Mapping<dim>::ExcTransformationFailed&) {
        continue;  // the point is outside the range in which this cell's map is invertible
      }
    }
    throw std::invalid_argument("gauge '" + gauge.name + "' lies outside the mesh (no cell contains it)");
  }

  const RichardsProblem& problem_;
  dealii::Triangulation<dim> triangulation_;
  dealii::FE_Q<dim> fe_;
  dealii::MappingQ<dim> mapping_;
  dealii::DoFHandler<dim> dofs_;
  std::vector<int> number_;  ///< deal.II's index -> ours
  Discretisation out_;
};

}  // namespace

Discretisation discretise(const RichardsProblem& problem) {
  dealii::MultithreadInfo::set_thread_limit(1);
  switch (problem.mesh.dim) {
    case 1:
      return Discretiser<1>(problem).run();
    case 2:
      return Discretiser<2>(problem).run();
    case 3:
      return Discretiser<3>(problem).run();
    default:
      throw std::invalid_argument("mesh.dim must be 1, 2 or 3");
  }
}

}  // namespace wetfront::fem_reference
