#pragma once

#include "mpm/stage_plan.h"

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

/// Unit vector against gravity; the last axis where there is no gravity.
template <int dim>
Vector<dim> upward(const Problem<dim>& problem);

/// Horizontal area that each node of a side stands for [m^(dim-1)], in the order of `side.nodes`: rain falls per
/// horizontal area. Throws CannotPlan when the side is vertical or faces downwards, so that rain cannot fall on it.
template <int dim>
std::vector<double> horizontal_areas(const BoundarySide<dim>& side, const Problem<dim>& problem, const std::string& who,
                                     const Origin& origin);

}  // namespace wetfront::mpm
