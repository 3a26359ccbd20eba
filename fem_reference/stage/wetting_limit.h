#pragma once

#include "fem_reference/stage/flow_operator.h"

#include <vector>

namespace wetfront::fem_reference {

/// Newton's step in psi, shortened node by node where W(psi) bends too much for it (README, Stage kernel). Below the
/// head of greatest capacity W is convex: a wetting step in psi there overshoots by metres, one in W does not
/// (Krabbenhoft 2007; Brenner & Cances 2017). No step passes saturation, or the head of greatest capacity from above,
/// without stopping there.
class WettingLimit {
 public:
  explicit WettingLimit(const FlowOperator& flow);
  /// The head that a node at `head` gets when Newton asks for `head + change`; the flow operator holds W there.
  double moved(int dof, double head, double change) const;
  /// Below this head of a dof the capacity falls towards the dry end [m].
  double bend(int dof) const { return nodes_[dof].bend; }

 private:
  double wetted(int dof, double head, double change) const;

  struct Node {
    double bend, full;       ///< heads of greatest capacity and of saturation [m]
    double water, capacity;  ///< W and its slope at `bend`
  };
  const FlowOperator& flow_;
  std::vector<Node> nodes_;
};

}  // namespace wetfront::fem_reference
