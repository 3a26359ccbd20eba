#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>

/// How the two-velocity liquid joins a skeleton that deforms.
namespace wetfront::mpm {

namespace {

/// The liquid among those who act on the nodes of the skeleton. First of them: contact and sides act on what skeleton
/// and drag leave.
template <int dim>
class LiquidAtNodes : public NodalCondition<dim> {
 public:
  LiquidAtNodes(MovingLiquid<dim>& liquid, const StagePlan<dim>& plan) : liquid_(liquid), plan_(plan) {}
  void add_force() override { liquid_.add_force(); }
  void limit_acceleration() override { liquid_.solve(plan_.clock.dt); }

 private:
  MovingLiquid<dim>& liquid_;
  const StagePlan<dim>& plan_;
};

}  // namespace

template <int dim>
void TwoVelocityLiquid<dim>::join_moving(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  std::unique_ptr<MovingSkeleton<dim>> skeleton;
  if (plan.stage.liquid == LiquidScheme::explicit_drag)
    skeleton = std::make_unique<DraggedSkeleton<dim, ExplicitDrag>>(plan, *cycle_);
  else
    skeleton = std::make_unique<DraggedSkeleton<dim, ImplicitDrag>>(plan, *cycle_);
  w.moving = skeleton.get();
  w.skeleton = std::move(skeleton);
  w.pressures_in = w.conductivities_in = Phase::carry;
  w.flow_volume = &plan.provide_on_nodes({"volume of flow", "V_i", dim == 2 ? "m2" : "m3", 1, Lifetime::step});
  w.solid_velocity = &plan.provide_on_nodes({"skeleton velocity", "v_s", "m/s", dim});
  typename MovingLiquid<dim>::PointColumns points{&plan.require_on_points("position"),
                                                  &plan.require_on_points("volume"),
                                                  &plan.require_on_points("mass"),
                                                  &plan.require_on_points("velocity"),
                                                  point_water_,
                                                  point_velocity_};
  moving_ = std::make_unique<MovingLiquid<dim>>(plan, w, points, liquid_weight(plan));
  w.liquid = moving_.get();
  w.body = &moving_->body();
  w.block_pressure = [this](const Block& block) { return moving_->block(block).pressure; };
  cycle_->conditions.insert(cycle_->conditions.begin(), std::make_unique<LiquidAtNodes<dim>>(*moving_, plan));
  moving_->at_other_body([this] { clear_left_nodes(); });
  plan.at_ready([this] {
    moving_->begin_body();
    moving_->sum();
  });
  plan.at_begin([this] { outside_holds_ = true; });  // first values are given to all nodes
  add_moving_momentum(plan);
  add_moving_balance(plan);
  // Measured by step/two_velocity_unsaturated of the benchmarks; the skeleton's own share is its own.
  plan.expect_cost(60e-9 * static_cast<double>(plan.fields.points.size()));
}

/// Nodes that no cell with points has any more forget what the liquid was there; when a stage begins all that have
/// none.
template <int dim>
void TwoVelocityLiquid<dim>::clear_left_nodes() {
  TwoVelocityWater<dim>& w = *water_;
  std::vector<int> outside;
  if (outside_holds_) {
    std::vector<char> there(w.flux->size());
    for (int i : w.body->nodes()) there[static_cast<std::size_t>(i)] = 1;
    for (std::size_t i = 0; i < there.size(); ++i)
      if (there[i] == 0) outside.push_back(static_cast<int>(i));
  }
  const std::vector<int>& left = outside_holds_ ? outside : w.body->left_nodes();
  outside_holds_ = false;
  for (Column* column : {w.flux, w.pressure, w.solid_velocity, w.rain_rate, w.volume, w.content})
    for (int a = 0; a < column->spec().components; ++a)
      for (int i : left) (*column)[a][i] = 0;
}

template <int dim>
void TwoVelocityLiquid<dim>::add_moving_momentum(StagePlan<dim>& plan) {
  plan.add(Phase::accelerate, "liquid after contact and sides", [this, &plan] {
    if (cycle_->conditions.size() > 1) moving_->follow_skeleton(plan.clock.dt);
  });
  plan.add(Phase::point_velocity, "liquid velocity to points and back",
           [this, &plan] { moving_->points(plan.clock.dt); });
}

template <int dim>
void TwoVelocityLiquid<dim>::add_moving_balance(StagePlan<dim>& plan) {
  blow_up_ = std::make_unique<BlowUp<dim>>(plan, *water_);
  plan.add(Phase::strain, "Darcy flux", [this, watch = blow_up_.get()] {
    watch->remember();
    moving_->relative_velocity();
    watch->examine();
  });
  const bool as_printed = plan.stage.mass_balance == MassBalance::printed_2021;
  plan.add(Phase::pressure, as_printed ? "mass balance as printed in 2021" : "mass balance",
           [this, &plan, as_printed] { moving_->balance(plan.clock.dt, as_printed); });
  plan.add(Phase::carry, "water of cells and nodes", [this] { moving_->sum(); });
}

template void TwoVelocityLiquid<2>::join_moving(StagePlan<2>&);
template void TwoVelocityLiquid<3>::join_moving(StagePlan<3>&);

}  // namespace wetfront::mpm
