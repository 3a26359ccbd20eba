#pragma once

#include "mpm/two_velocity/moving_liquid.h"

/// How the threads share the loops of a moving body's liquid. What they compute does not depend on their number: runs
/// of cells that share a node follow each other in one order, and what runs find is added up in theirs.
namespace wetfront::mpm {

/// body(blocks, found) for the blocks of one soil in each run of cells.
template <int dim>
template <class Body>
void MovingLiquid<dim>::over_cells(const Body& body) {
  for (const auto& colour : chunks_.colours())
    team_.run(colour.size(), [&](std::size_t k) {
      for (std::size_t soil = 0; soil < laws_.size(); ++soil)
        body(chunks_.blocks(plan_.fields.points, colour[k], static_cast<int>(soil)),
             found_[soil * chunks_.size() + colour[k]]);
    });
}

/// body(i) for the nodes of the body, which must not touch other nodes.
template <int dim>
template <class Body>
void MovingLiquid<dim>::over_nodes(const Body& body) {
  constexpr std::size_t run = 1024;
  const std::vector<int>& nodes = body_.nodes();
  team_.run((nodes.size() + run - 1) / run, [&](std::size_t k) {
    for (std::size_t n = k * run; n < std::min(nodes.size(), (k + 1) * run); ++n)
      body(static_cast<std::size_t>(nodes[n]));
  });
}

/// body(run) for runs of nodes of the body that lie one after the other.
template <int dim>
template <class Body>
void MovingLiquid<dim>::over_node_runs(const Body& body) {
  const auto& runs = body_.node_runs();
  team_.run(runs.size(), [&](std::size_t k) { body(runs[k]); });
}

}  // namespace wetfront::mpm
