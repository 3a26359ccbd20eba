#pragma once

#include "mpm/plan/stage_plan.h"

#include <string>
#include <vector>

namespace wetfront::mpm {

/// A named side of the mesh as boundary integrals of the shape functions.
template <int dim>
struct BoundarySide {
  struct Node {
    int index = 0;
    Vector<dim> area{};  ///< integral of N_i n over the side, n pointing outwards [m^(dim-1)]
    int region = 0;      ///< soil region behind (the lowest index where several meet)
  };
  std::string name;
  std::vector<Node> nodes;
};

/// Collects a side. `who` and `origin` name the entry that asked for it, for the message.
/// Throws CannotPlan when the side does not exist or when there is no point in any cell behind it.
template <int dim>
BoundarySide<dim> boundary_side(const StagePlan<dim>& plan, const std::string& name, const std::string& who,
                                const Origin& origin);

/// The side of that name; throws CannotPlan when the mesh has none.
const meshes::Side& named_side(const meshes::Mesh& mesh, const std::string& name, const std::string& who,
                               const Origin& origin);

/// "'base', 'top'", for messages; "none".
std::string side_names(const meshes::Mesh& mesh);

/// Unit vector against gravity; the last axis where there is no gravity.
template <int dim>
Vector<dim> upward(const Problem<dim>& problem);

/// Area that each node of a side stands for [m^(dim-1)], in the order of `side.nodes`. Rain falls per horizontal area;
/// throws CannotPlan when the side is vertical or faces downwards, so that none can fall on it. A side on which it
/// never rains, a seepage face, may face any way: its whole area counts.
template <int dim>
std::vector<double> open_areas(const BoundarySide<dim>& side, const Problem<dim>& problem, const RainSide& rain);

}  // namespace wetfront::mpm
