#pragma once

#include "fem_reference/space/discretisation.h"

#include <span>
#include <vector>

namespace wetfront::fem_reference {

/// The mesh of the record: the problem's own, or with adaptivity that mesh halved as often as cells may be, so that
/// every mesh of the run is nested in it and a field of any of them is given there exactly.
class RecordMesh {
 public:
  /// `space`: any discretisation of the problem; it knows the order of the corners of the problem's cells.
  RecordMesh(const RichardsProblem& problem, const Discretisation& space);

  const meshes::Mesh& mesh() const { return mesh_; }
  /// Cell of the problem's mesh in which a cell of mesh() lies.
  int mesh_cell(std::size_t cell) const { return static_cast<int>(cell / parts_); }

  /// A field given at the degrees of freedom, then at the ghosts, at the nodes of mesh(); all ranks have the result.
  std::vector<double> at_nodes(const Discretisation& space, std::span<const double> field) const;
  /// The same at the centres of the cells of mesh().
  std::vector<double> at_cells(const Discretisation& space, std::span<const double> field) const;

  /// Volume around a node that belongs to one soil (Gauss-Lobatto's weights; it only weighs saturations where soils
  /// meet).
  struct NodeShare {
    int node, soil;
    double volume;
  };
  const std::vector<NodeShare>& shares() const { return shares_; }
  /// Area on which a node of mesh() catches what conditions offer: horizontal for rain, whole for a FluxSide.
  std::vector<double> catchment() const;

 private:
  void place_cells(const Discretisation& space);
  void find_shares();
  /// +1 or -1 per face of a side of the problem's mesh: whether corner_areas() looks out of the soil.
  std::vector<double> outward(const meshes::Side& side) const;
  template <class Visit>
  void visit_parts(const Discretisation& space, std::span<const double> field, Visit visit) const;

  const RichardsProblem& problem_;
  meshes::Mesh mesh_;
  int levels_, size_;      ///< halvings, 2^halvings
  std::size_t parts_ = 1;  ///< cells of mesh() in one of the problem's mesh
  std::vector<NodeShare> shares_;
  std::vector<int> cell_at_;      ///< [mesh cell][lattice cell (Box)] -> cell
  std::vector<unsigned> corner_;  ///< [mesh cell][gmsh corner] -> bits, one per axis of deal.II
};

}  // namespace wetfront::fem_reference
