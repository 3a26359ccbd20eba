#pragma once

#include "mpm/skeleton/skeleton_cycle.h"
#include "mpm/two_velocity/drag.h"

#include <memory>
#include <vector>

namespace wetfront::mpm {

template <int dim>
struct TwoVelocityWater;

/// Velocities of both phases at a node [m/s].
template <int dim>
struct Velocities {
  Vector<dim> liquid{}, solid{};
};

/// The skeleton as the liquid meets it at the nodes: who drags, who is dragged, who gives way. The one place where the
/// two-velocity scheme distinguishes a resting skeleton from a moving one.
template <int dim>
class SkeletonAtNodes {
 public:
  virtual ~SkeletonAtNodes() = default;

  /// v_s at the nodes: at the start of the step in steps I and II, mapped back from the points from step III on.
  virtual Vector<dim> velocity(std::size_t node) const = 0;
  /// Both velocities after a step dt with the drag of a mobility k k_rel/mu [m2/(Pa s)] (drag.h).
  virtual Velocities<dim> driven(const TwoVelocityWater<dim>& water, std::size_t node, double mobility,
                                 double dt) const = 0;
  /// Changes v_l - v_s by `change` and keeps the momentum of the two phases (a fixed skeleton takes it all).
  virtual void change_relative(const TwoVelocityWater<dim>& water, std::size_t node, const Vector<dim>& change,
                               Velocities<dim>& v) const = 0;
  /// Hands the new v_s of step II to the skeleton (as its acceleration), and gives it back.
  virtual void set_new(std::size_t node, const Vector<dim>& solid, double dt) = 0;
  virtual Vector<dim> get_new(std::size_t node, double dt) const = 0;
};

/// v_s = 0.
template <int dim, class Drag>
class RestingSkeleton : public SkeletonAtNodes<dim> {
 public:
  Vector<dim> velocity(std::size_t) const override { return {}; }
  Velocities<dim> driven(const TwoVelocityWater<dim>& water, std::size_t node, double mobility,
                         double dt) const override;
  void change_relative(const TwoVelocityWater<dim>&, std::size_t, const Vector<dim>& change,
                       Velocities<dim>& v) const override {
    for (int a = 0; a < dim; ++a) v.liquid[a] += change[a];
  }
  void set_new(std::size_t, const Vector<dim>&, double) override {}
  Vector<dim> get_new(std::size_t, double) const override { return {}; }
};

/// Couples to the nodal columns of a deforming skeleton, as one of its conditions: the force on both phases is damped,
/// divided and fixed by the skeleton (a = f/m_s); then the drag divides the momentum between the phases.
template <int dim>
class MovingSkeleton : public SkeletonAtNodes<dim> {
 public:
  MovingSkeleton(StagePlan<dim>& plan, const SkeletonCycle<dim>& cycle);

  Vector<dim> velocity(std::size_t node) const override;
  void change_relative(const TwoVelocityWater<dim>& water, std::size_t node, const Vector<dim>& change,
                       Velocities<dim>& v) const override;
  void set_new(std::size_t node, const Vector<dim>& solid, double dt) override;
  Vector<dim> get_new(std::size_t node, double dt) const override;
  /// Step II at nodes that lie one after the other, as if neither walls nor fixities held them: both velocities, the
  /// skeleton's as its acceleration.
  virtual void solve(const TwoVelocityWater<dim>& water, const NodeRun& run, double dt) = 0;
  /// The same anew at a node that walls or fixities do hold.
  virtual void solve_held(const TwoVelocityWater<dim>& water, std::size_t node, double dt) = 0;
  /// Some axis of the skeleton is held there.
  bool fixed(std::size_t node) const {
    for (int a = 0; a < dim; ++a)
      if (fixed(a, node)) return true;
    return false;
  }

  /// v_s + dt a with v_s as it was at the start of the step, when the column holds another one already.
  Vector<dim> get_new(Vector<dim> start, std::size_t node, double dt) const {
    for (int a = 0; a < dim; ++a) start[a] += dt * acceleration_[a][node];
    return start;
  }
  /// The liquid's velocity against a skeleton that others (contact, moving sides) have given the velocity `solid`.
  virtual Vector<dim> liquid_against(const TwoVelocityWater<dim>& water, std::size_t node, const Vector<dim>& solid,
                                     double dt) const = 0;

  Column& force() { return force_; }
  Column& velocity_column() { return velocity_; }

 protected:
  bool fixed(int axis, std::size_t node) const {
    const auto& held = cycle_.fixed[static_cast<std::size_t>(axis)];
    return !held.empty() && held[node] != 0;
  }

  const SkeletonCycle<dim>& cycle_;
  Column &velocity_, &mass_, &force_, &acceleration_;
  Column& free_;  ///< f/m_s of the force on both phases, before the drag divides it [m/s2]
};

/// A moving skeleton with its drag.
template <int dim, class Drag>
class DraggedSkeleton final : public MovingSkeleton<dim> {
 public:
  using MovingSkeleton<dim>::MovingSkeleton;
  Velocities<dim> driven(const TwoVelocityWater<dim>& water, std::size_t node, double mobility,
                         double dt) const override;
  Vector<dim> liquid_against(const TwoVelocityWater<dim>& water, std::size_t node, const Vector<dim>& solid,
                             double dt) const override;
  void solve(const TwoVelocityWater<dim>& water, const NodeRun& run, double dt) override;
  void solve_held(const TwoVelocityWater<dim>& water, std::size_t node, double dt) override;

 private:
  template <class Number>
  NodalDrag<Number> before_drag(const TwoVelocityWater<dim>& water, std::size_t node, int axis, const Number& per_force,
                                const Number& drag) const;
  template <class Number>
  void drag_freely(const TwoVelocityWater<dim>& water, std::size_t node, double dt);
};

}  // namespace wetfront::mpm
