#pragma once

#include "fem_reference/space/periodic.h"
#include "fem_reference/space/triangulate.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <numeric>
#include <set>

// From deal.II's numbers of nodes to ours. For space.cpp only.
namespace wetfront::fem_reference {

using DealiiIndex = dealii::types::global_dof_index;

/// The nodes of one cell in terms of its unknowns: u_node = sum over k of weight[node][k] u_{dof[k]}.
struct CellUnknowns {
  std::vector<int> dof;        ///< [local dof], our numbers
  std::vector<double> weight;  ///< [node][local dof]; the identity where nothing hangs
};

/// Numbers the unknowns: nodes that do not hang, upwards, periodic partners as one.
template <int dim>
class Numbering {
 public:
  Numbering(const RichardsProblem& problem, const dealii::DoFHandler<dim>& dofs, const dealii::MappingQ<dim>& mapping)
      : problem_(problem), dofs_(dofs), mapping_(mapping) {
    if (dofs.get_triangulation().has_hanging_nodes()) {
      dealii::DoFTools::make_hanging_node_constraints(dofs, hanging_);
      hanging_.close();
    }
    number_upwards();
    merge_periodic();
  }

  /// Unknowns of this rank; its ghosts are numbered behind them.
  int count() const { return static_cast<int>(position_.size()) - ghosts_; }
  const std::vector<meshes::Point>& positions() const { return position_; }
  /// deal.II's number of each of ours; without periodic sides.
  std::vector<long long> ids() const {
    std::vector<long long> id(position_.size());
    for (DealiiIndex index = 0; index < number_.size(); ++index) {
      if (number_[index] >= 0) id[number_[index]] = static_cast<long long>(index);
    }
    return id;
  }
  /// Whether this rank computes a cell: it touches an unknown of its own (all do of a mesh held whole).
  template <class Cell>
  bool here(const Cell& cell) const {
    if (dofs_.locally_owned_dofs().n_elements() == dofs_.n_dofs()) return true;
    if (cell->is_artificial()) return false;
    std::vector<DealiiIndex> nodes(dofs_.get_fe().n_dofs_per_cell());
    cell->get_dof_indices(nodes);
    return std::any_of(nodes.begin(), nodes.end(), [&](DealiiIndex i) { return own(i); });
  }
  /// Ours for deal.II's; -1 for a hanging node.
  int operator[](DealiiIndex index) const { return number_[index]; }

  /// The unknowns of a cell from its nodes. A hanging node's place goes to the one master that is no node of the cell:
  /// the far end of a parent's edge, the opposite corner of a parent's face (README, Eq 6).
  void unknowns(const std::vector<DealiiIndex>& nodes, CellUnknowns& cell) const {
    const std::size_t n = nodes.size();
    std::vector<DealiiIndex> slot(nodes);
    for (const std::size_t masters : {2, 4}) {  // edges before faces, whose masters they place
      for (std::size_t a = 0; a < n; ++a) {
        const auto* entries = hanging_.get_constraint_entries(nodes[a]);
        if (entries == nullptr || entries->size() != masters) continue;
        for (const auto& [master, weight] : *entries) {
          if (std::find(slot.begin(), slot.end(), master) == slot.end()) slot[a] = master;
        }
      }
    }
    cell.weight.assign(n * n, 0);
    cell.dof.resize(n);
    const auto add = [&](std::size_t node, DealiiIndex master, double weight) {
      const auto place = std::find(slot.begin(), slot.end(), master);
      if (place == slot.end()) throw std::logic_error("hanging nodes: a cell with more masters than corners");
      cell.weight[node * n + (place - slot.begin())] += weight;
    };
    for (std::size_t a = 0; a < n; ++a) {
      cell.dof[a] = number_[slot[a]];
      if (cell.dof[a] < 0) throw std::logic_error("hanging nodes: a master that hangs");
      const auto* entries = hanging_.get_constraint_entries(nodes[a]);
      if (entries == nullptr) {
        cell.weight[a * n + a] = 1;
        continue;
      }
      for (const auto& [master, weight] : *entries) add(a, master, weight);
    }
  }

 private:
  bool own(DealiiIndex index) const { return dofs_.locally_owned_dofs().is_element(index); }

  // Numbering upwards makes a column, or a strip a few cells wide, a narrow band for the linear solver.
  void number_upwards() {
    const auto& fe = dofs_.get_fe();
    std::vector<meshes::Point> position(dofs_.n_dofs());
    std::vector<DealiiIndex> nodes(fe.n_dofs_per_cell()), order;
    std::vector<char> seen(dofs_.n_dofs(), 0);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      if (!here(cell)) continue;
      cell->get_dof_indices(nodes);
      for (unsigned int a = 0; a < nodes.size(); ++a) {
        position[nodes[a]] = to_point(mapping_.transform_unit_to_real_cell(cell, fe.unit_support_point(a)));
        if (!seen[nodes[a]] && !hanging_.is_constrained(nodes[a])) order.push_back(nodes[a]);
        seen[nodes[a]] = 1;
      }
    }
    std::sort(order.begin(), order.end(), [&](DealiiIndex a, DealiiIndex b) {
      if (own(a) != own(b)) return own(a);
      for (int axis = dim - 1; axis >= 0; --axis) {
        if (position[a][axis] != position[b][axis]) return position[a][axis] < position[b][axis];
      }
      return a < b;
    });
    number_.assign(dofs_.n_dofs(), -1);
    for (const DealiiIndex index : order) {
      number_[index] = static_cast<int>(position_.size());
      position_.push_back(position[index]);
      if (!own(index)) ++ghosts_;
    }
  }

  std::vector<int> dofs_on(const std::string& side) const {
    const unsigned int id = boundary_id(problem_.mesh, side);
    const auto& fe = dofs_.get_fe();
    std::set<int> found;
    std::vector<DealiiIndex> nodes(fe.n_dofs_per_cell());
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(nodes);
      for (unsigned int f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != id) continue;
        for (unsigned int a = 0; a < nodes.size(); ++a) {
          if (fe.has_support_on_face(a, f) && number_[nodes[a]] >= 0) found.insert(number_[nodes[a]]);
        }
      }
    }
    return {found.begin(), found.end()};
  }

  void merge_periodic() {
    if (ghosts_ > 0) return;  // periodic sides are not shared between ranks
    PeriodicGroups groups(count(), dim);
    for (const BoundaryCondition& condition : problem_.boundary) {
      const auto* pair = std::get_if<PeriodicSides>(&condition);
      if (pair != nullptr) groups.pair(*pair, dofs_on(pair->side), dofs_on(pair->partner), position_);
    }
    const std::vector<int> merged = groups.numbers();
    std::vector<meshes::Point> position;
    for (std::size_t i = 0; i < merged.size(); ++i) {
      if (merged[i] == static_cast<int>(position.size())) position.push_back(position_[i]);
    }
    position_ = std::move(position);
    for (int& number : number_) number = number < 0 ? -1 : merged[number];
  }

  const RichardsProblem& problem_;
  const dealii::DoFHandler<dim>& dofs_;
  const dealii::MappingQ<dim>& mapping_;
  dealii::AffineConstraints<double> hanging_;
  std::vector<int> number_;  ///< deal.II's index -> ours
  std::vector<meshes::Point> position_;
  int ghosts_ = 0;
};

}  // namespace wetfront::fem_reference
