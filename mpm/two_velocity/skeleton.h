#pragma once

#include "mpm/plan/stage_plan.h"
#include "mpm/two_velocity/drag.h"

#include <memory>

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

/// Couples to the nodal columns of the elastic skeleton. The liquid adds its pull to the skeleton's force before that
/// is damped, and overrules the acceleration after the drag is solved.
template <int dim>
class MovingSkeleton : public SkeletonAtNodes<dim> {
 public:
  explicit MovingSkeleton(StagePlan<dim>& plan);

  /// From the momentum (step I) or the velocity (step III) in the skeleton's nodal column.
  void read_momentum();
  void read_velocity();

  Vector<dim> velocity(std::size_t node) const override;
  void change_relative(const TwoVelocityWater<dim>& water, std::size_t node, const Vector<dim>& change,
                       Velocities<dim>& v) const override;
  void set_new(std::size_t node, const Vector<dim>& solid, double dt) override;
  Vector<dim> get_new(std::size_t node, double dt) const override;
  Column& force() { return force_; }

 protected:
  bool fixed(int axis, std::size_t node) const { return fixed_[static_cast<std::size_t>(axis)][node] != 0; }

  Column &velocity_, &mass_, &force_, &momentum_, &acceleration_;
  std::array<std::vector<char>, dim> fixed_;
};

/// A moving skeleton with its drag.
template <int dim, class Drag>
class DraggedSkeleton final : public MovingSkeleton<dim> {
 public:
  using MovingSkeleton<dim>::MovingSkeleton;
  Velocities<dim> driven(const TwoVelocityWater<dim>& water, std::size_t node, double mobility,
                         double dt) const override;
};

}  // namespace wetfront::mpm
