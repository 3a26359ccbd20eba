#pragma once

#include "mpm/boundary/contact_gaps.h"
#include "mpm/boundary/rigid_planes.h"
#include "mpm/boundary/skeleton_nodes.h"

#include <span>

namespace wetfront::mpm {

/// The rigid base of the body: all FrictionalContact sides together. With v* = v + dt a, at each node
///
///     v' = nearest to v* with v'.n_k <= gap_k/dt,   R_k dt = m lambda_k,   |friction| <= sum_k mu_k (R_k - A_k p_w),
///
/// where p_w is the part of the wall's reaction per area that pore water carries (friction acts on the effective
/// reaction). The node sticks where friction can stop what of v' is along the base, else it slows it down. It lifts off
/// freely: no plane pulls, and a body that has lifted comes down again (ContactGaps). Axes that fixities hold stay as
/// they are. In MUSL the velocities mapped back are kept out of the base too.
template <int dim>
class ContactCondition : public NodalCondition<dim> {
 public:
  ContactCondition(StagePlan<dim>& plan, SkeletonCycle<dim>& cycle, const std::vector<FrictionalContact>& sides);
  void see_force() override;
  void limit_acceleration() override;
  void limit_velocity() override;

 private:
  struct Node {
    std::size_t index = 0;
    std::size_t first = 0, count = 0;  ///< of its planes
    std::array<bool, dim> held{};
    bool sticks = false;  ///< friction stops all of its velocity along the base in this step
    Vector<dim> stuck{};  ///< the velocity it has while it sticks [m/s]: none, or what closes a gap
    Vector<dim> force{};  ///< before damping [N; N/m]
  };
  void find_wall_pressure();
  void damp(const Node& node, Vector<dim>& v);
  /// What the base stops at a node [kg; kg/m], and what of its reaction per area is the water's [Pa].
  struct Wet {
    double mass, pressure;
  };
  Wet wet(const Node& node) const;
  void find_gaps();
  RigidPlanes<dim> planes(const Node& node) const;
  std::span<double> impulse(const Node& node);
  void stop_at_planes(Node& node, Vector<dim>& v, double dt);

  StagePlan<dim>& plan_;
  SkeletonCycle<dim>& cycle_;
  SkeletonNodes<dim> nodes_;
  bool damped_ = false;  ///< reactions are found from forces before damping
  std::vector<Node> base_;
  std::vector<Vector<dim>> normal_;  ///< of each node's planes, in the axes that are not held; length 1
  std::vector<double> friction_, area_, impulse_, approach_;  ///< of the planes: -; m2 or m; m/s, > 0 bears; m/s
  ContactGaps<dim> gaps_;
  const Column *node_pressure_ = nullptr, *pore_stress_ = nullptr, *volume_ = nullptr;
  std::vector<double> wall_pressure_, weight_;  ///< per node of the grid [Pa; m3 or m2]; with seepage only
  struct {
    const Column *pressure = nullptr, *content = nullptr, *volume = nullptr, *extent = nullptr;
  } liquid_;  ///< of two velocities
};

}  // namespace wetfront::mpm
