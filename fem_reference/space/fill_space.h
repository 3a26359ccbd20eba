#pragma once

#include "fem_reference/space/discretisation.h"
#include "fem_reference/space/numbering.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

// The flat arrays of a discretisation. For space.cpp only.
namespace wetfront::fem_reference {

template <int dim>
class SpaceFiller {
 public:
  /// `shared`: on all ranks at once, each filling in its part.
  SpaceFiller(const RichardsProblem& problem, const dealii::DoFHandler<dim>& dofs, const dealii::MappingQ<dim>& mapping,
              bool shared)
      : problem_(problem),
        shared_(shared),
        dofs_(dofs),
        mapping_(mapping),
        fe_(dofs.get_fe()),
        numbering_(problem, dofs, mapping) {}

  Discretisation run() {
    out_.dim = dim;
    out_.levels = problem_.adaptivity ? problem_.adaptivity->levels : 0;
    out_.dofs_per_cell = static_cast<int>(fe_.n_dofs_per_cell());
    out_.dof_count = numbering_.count();
    out_.position = numbering_.positions();
    if (shared_) out_.ranks = Ranks(numbering_.ids(), out_.dof_count);
    nodes_.resize(fe_.n_dofs_per_cell());
    unknowns_.weight.assign(nodes_.size() * nodes_.size(), 0);  // pattern 0: nothing hangs
    for (std::size_t a = 0; a < nodes_.size(); ++a) unknowns_.weight[a * nodes_.size() + a] = 1;
    pattern_of(unknowns_.weight);
    fill_mesh_corners();
    fill_cells();
    fill_sides();
    for (const Gauge& gauge : problem_.gauges) {
      out_.gauges.push_back(locate(gauge));
      if (!out_.ranks.any(out_.gauges.back().cell >= 0)) lies_outside(gauge);
    }
    return std::move(out_);
  }

 private:
  /// Neither hanging nor a ghost.
  bool is_unknown(int dof) const { return dof >= 0 && dof < out_.dof_count; }

  template <class Cell>
  void visit(const Cell& cell) {
    cell->get_dof_indices(nodes_);
    numbering_.unknowns(nodes_, unknowns_);
  }

  void fill_mesh_corners() {
    out_.mesh_corner.resize(problem_.mesh.cell_count() * out_.corners());
    for (const auto& cell : dofs_.get_triangulation().cell_iterators_on_level(0)) {
      const std::size_t first = static_cast<std::size_t>(cell->index()) * out_.corners();
      for (const unsigned int v : cell->vertex_indices()) out_.mesh_corner[first + v] = cell->vertex_index(v);
    }
  }

  void fill_cells() {
    const dealii::QGauss<dim> gauss(problem_.degree + 1);
    // The lumped mass: the integral of the shape function, which nests and keeps the volume of distorted cells; beyond
    // degree 1, where that may vanish, the weights of the Gauss-Lobatto rule whose points are the nodes.
    const dealii::QGaussLobatto<dim> nodes(problem_.degree + 1);
    const dealii::Quadrature<dim>& nodal =
        problem_.degree == 1 ? static_cast<const dealii::Quadrature<dim>&>(gauss) : nodes;
    dealii::FEValues<dim> values(mapping_, fe_, gauss, dealii::update_gradients | dealii::update_JxW_values);
    dealii::FEValues<dim> lumped(mapping_, fe_, nodal, dealii::update_values | dealii::update_JxW_values);
    out_.points_per_cell = static_cast<int>(gauss.size());
    out_.node_dof.assign(problem_.mesh.node_count(), -1);
    out_.initial_head.assign(out_.dof_count, 0);
    std::map<std::pair<int, int>, double> volume;
    for (const auto& cell : dofs_.active_cell_iterators()) {
      if (!numbering_.here(cell)) continue;
      visit(cell);
      values.reinit(cell);
      lumped.reinit(cell);
      append_cell(cell);
      append_points(values);
      add_volumes(lumped, cell->material_id(), volume);
    }
    for (const auto& [key, share] : volume) out_.storage.push_back({key.first, key.second, share});
    fill_shapes(gauss);
  }

  using AnyCell = typename dealii::DoFHandler<dim>::cell_iterator;

  // Not the id's coarse cell: where p4est divides the mesh that is the number of its tree.
  static AnyCell mesh_cell(AnyCell cell) {
    while (cell->level() > 0) cell = cell->parent();
    return cell;
  }

  template <class Cell>
  void append_cell(const Cell& cell) {
    const auto id = cell->id();
    Box box{mesh_cell(cell)->index(), cell->level(), {}};
    int size = 1 << out_.levels;
    for (const auto child : id.get_child_indices()) {
      size /= 2;
      for (int axis = 0; axis < dim; ++axis) box.low[axis] += (child >> axis & 1) * size;
    }
    ++out_.cell_count;
    out_.cell_soil.push_back(static_cast<int>(cell->material_id()));
    out_.mesh_cell.push_back(box.mesh_cell);
    out_.box.push_back(box);
    out_.cell_pattern.push_back(pattern_of(unknowns_.weight));
    out_.cell_dofs.insert(out_.cell_dofs.end(), unknowns_.dof.begin(), unknowns_.dof.end());
    for (const unsigned int v : cell->vertex_indices()) {
      const unsigned int vertex = cell->vertex_index(v);  // the mesh's nodes come first and never hang
      if (vertex < out_.node_dof.size()) out_.node_dof[vertex] = numbering_[cell->vertex_dof_index(v, 0)];
    }
    fill_initial_head(mesh_cell(cell), box, 1.0 / (1 << out_.levels), size);
  }

  // The given heads are multilinear between the nodes of the mesh.
  void fill_initial_head(const AnyCell& cell, const Box& box, double step, int size) {
    for (std::size_t a = 0; a < nodes_.size(); ++a) {
      if (!is_unknown(numbering_[nodes_[a]])) continue;
      dealii::Point<dim> unit = fe_.unit_support_point(a);
      for (int axis = 0; axis < dim; ++axis) unit[axis] = step * (box.low[axis] + size * unit[axis]);
      double head = 0;
      for (const unsigned int v : cell->vertex_indices()) {
        head +=
            problem_.initial_head[cell->vertex_index(v)] * dealii::GeometryInfo<dim>::d_linear_shape_function(unit, v);
      }
      out_.initial_head[numbering_[nodes_[a]]] = head;
    }
  }

  void append_points(const dealii::FEValues<dim>& values) {
    const std::size_t n = nodes_.size();
    for (int q = 0; q < out_.points_per_cell; ++q) {
      out_.weight.push_back(values.JxW(q));
      for (std::size_t k = 0; k < n; ++k) {
        dealii::Tensor<1, dim> gradient;
        for (std::size_t a = 0; a < n; ++a) {
          if (unknowns_.weight[a * n + k] != 0) gradient += unknowns_.weight[a * n + k] * values.shape_grad(a, q);
        }
        for (int axis = 0; axis < dim; ++axis) out_.gradient.push_back(gradient[axis]);
      }
    }
  }

  void add_volumes(const dealii::FEValues<dim>& lumped, int soil, std::map<std::pair<int, int>, double>& volume) {
    const std::size_t n = nodes_.size();
    for (std::size_t a = 0; a < n; ++a) {
      double share = 0;
      for (unsigned int q = 0; q < lumped.n_quadrature_points; ++q) share += lumped.shape_value(a, q) * lumped.JxW(q);
      if (problem_.degree == 1) out_.corner_volume.push_back(share);
      for (std::size_t k = 0; k < n; ++k) {
        const double weight = unknowns_.weight[a * n + k];
        if (weight != 0 && is_unknown(unknowns_.dof[k])) volume[{unknowns_.dof[k], soil}] += weight * share;
      }
    }
  }

  int pattern_of(const std::vector<double>& weight) {
    return pattern_.try_emplace(weight, static_cast<int>(pattern_.size())).first->second;
  }

  void fill_shapes(const dealii::Quadrature<dim>& gauss) {
    std::vector<const std::vector<double>*> by_index(pattern_.size());
    for (const auto& [weight, index] : pattern_) by_index[index] = &weight;
    dealii::Point<dim> centre;
    for (int axis = 0; axis < dim; ++axis) centre[axis] = 0.5;
    for (const std::vector<double>* weight : by_index) {
      for (const auto& point : gauss.get_points()) append_shape(point, *weight, out_.shape);
      append_shape(centre, *weight, out_.centre_shape);
      for (int v = 0; v < out_.corners(); ++v) {
        append_shape(dealii::GeometryInfo<dim>::unit_cell_vertex(v), *weight, out_.corner_shape);
      }
    }
  }

  void append_shape(const dealii::Point<dim>& unit, const std::vector<double>& weight,
                    std::vector<double>& into) const {
    const std::size_t n = nodes_.size();
    for (std::size_t k = 0; k < n; ++k) {
      double value = 0;
      for (std::size_t a = 0; a < n; ++a) {
        if (weight[a * n + k] != 0) value += weight[a * n + k] * fe_.shape_value(a, unit);
      }
      into.push_back(value);
    }
  }

  void fill_sides() {
    const dealii::QGauss<dim - 1> gauss(problem_.degree + 1);
    dealii::FEFaceValues<dim> values(mapping_, fe_, gauss,
                                     dealii::update_values | dealii::update_JxW_values | dealii::update_normal_vectors);
    for (const BoundaryCondition& condition : problem_.boundary) {
      const std::string& name = std::visit([](const auto& c) -> const std::string& { return c.side; }, condition);
      const unsigned int id = boundary_id(problem_.mesh, name);
      std::map<std::pair<int, int>, SideShare> shares;
      int index = -1;
      for (const auto& cell : dofs_.active_cell_iterators()) {
        if (!numbering_.here(cell)) continue;
        ++index;
        for (const unsigned int f : cell->face_indices()) {
          if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != id) continue;
          visit(cell);
          values.reinit(cell, f);
          add_face(values, f, index, shares);
        }
      }
      out_.sides.emplace_back();
      for (const auto& [key, share] : shares) out_.sides.back().push_back(share);
    }
  }

  void add_face(const dealii::FEFaceValues<dim>& values, unsigned int face, int cell,
                std::map<std::pair<int, int>, SideShare>& shares) const {
    const int soil = out_.cell_soil[cell], n = out_.dofs_per_cell;
    const auto& factors = problem_.conductivity_factor;
    const double factor = factors.empty() ? 1 : factors[out_.mesh_cell[cell]];
    for (int a = 0; a < n; ++a) {
      if (!fe_.has_support_on_face(a, face)) continue;
      for (int k = 0; k < n; ++k) {
        const double weight = unknowns_.weight[a * n + k];
        const int dof = unknowns_.dof[k];
        if (weight == 0 || !is_unknown(dof)) continue;
        SideShare& share = shares.try_emplace({dof, soil}, SideShare{dof, soil, 0, 0, {}}).first->second;
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
          const double area = weight * values.shape_value(a, q) * values.JxW(q);
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
  }

  Place locate(const Gauge& gauge) {
    constexpr double slack = 1e-9;  // of the unit cell: a gauge on a face belongs to either neighbour
    const dealii::Point<dim> point = to_dealii<dim>(gauge.position);
    int index = -1;
    for (const auto& cell : dofs_.active_cell_iterators()) {
      if (!numbering_.here(cell)) continue;
      ++index;
      if (cell->center().distance(point) > cell->diameter()) continue;
      try {
        const dealii::Point<dim> unit = mapping_.transform_real_to_unit_cell(cell, point);
        if (!dealii::GeometryInfo<dim>::is_inside_unit_cell(unit, slack)) continue;
        Place place{index, {}};
        visit(cell);
        append_shape(unit, unknowns_.weight, place.shape);
        return place;
      } catch (const typename dealii::Mapping<dim>::ExcTransformationFailed&) {
        continue;  // the point is outside the range in which this cell's map is invertible
      }
    }
    return {-1, {}};
  }

  [[noreturn]] static void lies_outside(const Gauge& gauge) {
    throw std::invalid_argument("gauge '" + gauge.name + "' lies outside the mesh (no cell contains it)");
  }

  const RichardsProblem& problem_;
  const bool shared_;
  const dealii::DoFHandler<dim>& dofs_;
  const dealii::MappingQ<dim>& mapping_;
  const dealii::FiniteElement<dim>& fe_;
  Numbering<dim> numbering_;
  std::map<std::vector<double>, int> pattern_;  ///< weights of a cell's nodes -> index
  std::vector<DealiiIndex> nodes_;              ///< of the cell last visited
  CellUnknowns unknowns_;                       ///< of the cell last visited
  Discretisation out_;
};

}  // namespace wetfront::fem_reference
