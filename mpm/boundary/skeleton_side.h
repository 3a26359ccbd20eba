#pragma once

#include "mpm/plan/stage_plan.h"

#include <string>
#include <vector>

namespace wetfront::mpm {

/// A side of the mesh as its nodes see it: one entry per node and distinct plane through it. A node at a kink, or where
/// several sides meet, has several.
template <int dim>
struct SidePlane {
  Vector<dim> normal{};  ///< out of the mesh, length 1
  double area = 0;       ///< integral of N_i over the faces in this plane [m^(dim-1)]
};
template <int dim>
struct SideNode {
  int index = 0;
  int region = 0;  ///< of the first cell behind it
  std::vector<SidePlane<dim>> planes;
};

/// The nodes of a side, of all its faces or only of those with soil behind them. `who` and `origin` name the entry that
/// asks, for the message. Throws CannotPlan when the mesh has no such side.
template <int dim>
std::vector<SideNode<dim>> side_nodes(const StagePlan<dim>& plan, const std::string& side, const std::string& who,
                                      const Origin& origin, bool only_with_soil);

/// By how much `partner` lies from `side`: what is moved by it has gone through the one and come in at the other.
meshes::Point between_sides(const meshes::Mesh& mesh, const std::string& side, const std::string& partner,
                            const Origin& origin);

/// Groups of nodes that are one because sides are periodic, the lowest index first: pairs, or four or eight where pairs
/// of sides meet. `sides` holds (side, partner). Throws CannotPlan where a node has no image.
std::vector<std::vector<int>> tied_nodes(const meshes::Mesh& mesh, const std::vector<std::array<std::string, 2>>& sides,
                                         const Origin& origin);

}  // namespace wetfront::mpm
