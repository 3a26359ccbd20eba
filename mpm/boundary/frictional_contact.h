#pragma once

#include "mpm/boundary/skeleton_nodes.h"

#include <span>

namespace wetfront::mpm {

/// Velocity after contact with rigid planes of outward normals n_k: the nearest one that goes into none of them.
/// `impulse[k]` >= 0 is what plane k took away [m/s]. Planes are few (corners), so every set of at most `dim` active
/// ones is tried; by convexity one of them fits.
template <int dim>
Vector<dim> without_penetration(const Vector<dim>& velocity, std::span<const Vector<dim>> normals,
                                std::span<double> impulse);

/// The rigid base of the body: all FrictionalContact sides together. With v* = v + dt a, at each node
///
///     v' = nearest to v* with v'.n_k <= 0,   R_k dt = m lambda_k,   |friction| <= sum_k mu_k (R_k - A_k p_w),
///
/// where p_w is the part of the wall's reaction per area that pore water carries (friction acts on the effective
/// reaction). The node sticks where friction can stop what is left of v', else it slows it down. It lifts off freely:
/// no plane pulls. Axes that fixities hold stay as they are. In MUSL the velocities mapped back are kept out of the
/// base too.
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
    bool sticks = false;
    Vector<dim> force{};  ///< before damping
  };
  void find_wall_pressure();
  void damp(const Node& node, Vector<dim>& v);
  /// What the base stops at a node [kg], and the part of its reaction per area that is the water's [Pa].
  struct Wet {
    double mass, pressure;
  };
  Wet wet(const Node& node) const;
  bool stop_at_planes(Node& node, Vector<dim>& v, double dt);

  StagePlan<dim>& plan_;
  SkeletonCycle<dim>& cycle_;
  SkeletonNodes<dim> nodes_;
  bool damped_ = false;  ///< reactions are found from forces before damping
  std::vector<Node> base_;
  std::vector<Vector<dim>> normal_;  ///< of each node's planes, in the axes that are not held; length 1
  std::vector<double> friction_, area_, impulse_;
  const Column *node_pressure_ = nullptr, *pore_stress_ = nullptr, *volume_ = nullptr;
  std::vector<double> wall_pressure_, weight_;  ///< per node of the grid; with seepage only
  struct {
    const Column *pressure = nullptr, *content = nullptr, *volume = nullptr, *extent = nullptr;
  } liquid_;  ///< of two velocities
};

}  // namespace wetfront::mpm
