#include "mpm/record/motion_ledger.h"

#include "mpm/grid/migration.h"
#include "mpm/grid/point_sums.h"
#include "mpm/lanes.h"
#include "mpm/record/brought_by_water.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// Sums over the nodes of the runs of what terms(at) gives, where at(column) is its value at one node or at four: one
/// after the other every addition would wait for the one before.
template <std::size_t count, class Terms>
std::array<double, count> sum_over(const std::vector<NodeRun>& runs, const Terms& terms) {
  std::array<Lanes, count> four{};
  std::array<double, count> all{};
  for (const NodeRun& run : runs) {
    std::size_t i = run.first;
    for (; i + lane_count <= run.last; i += lane_count) {
      const auto values = terms([i](const double* column) { return load(column + i); });
      for (std::size_t k = 0; k < count; ++k) four[k] += values[k];
    }
    for (; i < run.last; ++i) {
      const auto values = terms([i](const double* column) { return column[i]; });
      for (std::size_t k = 0; k < count; ++k) all[k] += values[k];
    }
  }
  for (std::size_t k = 0; k < count; ++k) all[k] += mpm::sum(four[k]);
  return all;
}

}  // namespace

/// Sees the forces of stress (and weight) before the others add theirs.
template <int dim>
class MotionLedger<dim>::First : public NodalCondition<dim> {
 public:
  explicit First(MotionLedger& ledger) : ledger_(ledger) {}
  void add_force() override { ledger_.see_inner_force(); }

 private:
  MotionLedger& ledger_;
};

template <int dim>
class MotionLedger<dim>::Last : public NodalCondition<dim> {
 public:
  explicit Last(MotionLedger& ledger) : ledger_(ledger) {}
  void see_force() override {
    for (int a = 0; a < dim; ++a)
      for (const NodeRun& run : ledger_.cycle_->active->runs())
        std::copy((*ledger_.force_)[a] + run.first, (*ledger_.force_)[a] + run.last, (*ledger_.loaded_)[a] + run.first);
  }
  void limit_acceleration() override { ledger_.add_step(); }
  void see_velocity() override { ledger_.add_work(0.5, false); }

 private:
  MotionLedger& ledger_;
};

template <int dim>
void MotionLedger<dim>::join(StagePlan<dim>& plan) {
  plan_ = &plan;
  migrated_ = &plan.require_on_run("migration");
  mass_ = &plan.require_on_points("mass");
  position_ = &plan.require_on_points("position");
  velocity_ = &plan.require_on_points("velocity");
  node_mass_ = &plan.require_on_nodes("mass");
  force_ = &plan.require_on_nodes("force");
  node_velocity_ = &plan.require_on_nodes("velocity");
  acceleration_ = &plan.require_on_nodes("acceleration");
  const std::string force = dim == 2 ? "N/m" : "N";
  inner_ = &plan.provide_on_nodes({"force of stress", "f_int", force, dim, Lifetime::step});
  loaded_ = &plan.provide_on_nodes({"force with loads", "f", force, dim, Lifetime::step});
  sums_ = &plan.provide_on_run({"motion ledger", "W, I", "J, N s", count});
  // What a stage before has left goes when this one begins.
  if (Column* brought = plan.fields.run.find(brought_by_water(dim).name); brought && !brought->provided_by().empty())
    brought_ = brought;
  cycle_->conditions.insert(cycle_->conditions.begin(), std::make_unique<First>(*this));
  cycle_->conditions.push_back(std::make_unique<Last>(*this));
  // Each dynamic stage has a ledger of its own: a relaxation before it has no time and no momentum.
  plan.at_begin([this] {
    sums_->fill(0);
    if (brought_ != nullptr) brought_->fill(0);
    const Vector<dim> start = momentum();
    for (int a = 0; a < dim; ++a) (*sums_)[first + a][0] = start[a];
    (*sums_)[first_energy][0] = kinetic_energy(plan_->fields.points, *mass_, *velocity_) + potential_energy();
  });
  plan.at_record([this](double time, meshes::FieldHistory& history) { record(time, history); });
}

template <int dim>
void MotionLedger<dim>::see_inner_force() {
  const Vector<dim>& g = plan_->problem.gravity;
  for (int a = 0; a < dim; ++a) {
    const double *force = (*force_)[a], *mass = (*node_mass_)[0];
    double* inner = (*inner_)[a];
    for (const NodeRun& run : cycle_->active->runs())
      for (std::size_t i = run.first; i < run.last; ++i) inner[i] = force[i] - mass[i] * g[static_cast<std::size_t>(a)];
  }
}

template <int dim>
void MotionLedger<dim>::add_step() {
  add_impulse();
  const bool maps_back = plan_->problem.skeleton.update == StressUpdate::musl;
  if (maps_back)
    add_work(0.5, false);
  else
    add_work(1, true);
}

/// Work of the forces over the step, with the nodes' present velocities; `with_change`: and half of what they gain.
template <int dim>
void MotionLedger<dim>::add_work(double share, bool with_change) {
  const double dt = cycle_->dt;
  const double* mass = (*node_mass_)[0];
  double light = 0;
  for (const NodeRun& run : cycle_->active->runs())
    for (std::size_t i = run.first; with_change && i < run.last; ++i) light = std::max(light, 0.1 * mass[i]);
  for (int a = 0; a < dim; ++a) {
    const double *inner = (*inner_)[a], *loaded = (*loaded_)[a], *v = (*node_velocity_)[a], *at = (*acceleration_)[a];
    const double g = plan_->problem.gravity[static_cast<std::size_t>(a)];
    const auto [stress, load, held] = sum_over<3>(cycle_->active->runs(), [&](const auto& here) {
      const auto m = here(mass), change = here(at), f = here(inner), all = here(loaded);
      auto middle = here(v);
      using Number = std::decay_t<decltype(middle)>;
      if (with_change) middle += 0.5 * dt * change * min(Number(1.0), m / light);
      // Gravity's work is in its potential.
      return std::array<Number, 3>{-f * middle, (all - f - m * g) * middle, (m * change - all) * middle};
    });
    (*sums_)[stress_work][0] += share * dt * stress;
    (*sums_)[load_work][0] += share * dt * load;
    (*sums_)[resistance][0] += share * dt * held;
  }
}

template <int dim>
void MotionLedger<dim>::add_impulse() {
  const double dt = cycle_->dt;
  const double* mass = (*node_mass_)[0];
  // Points that take the nodes' velocities themselves lose what held nodes have lost of theirs: where stress comes
  // first nodes are held before the points look.
  const SkeletonScheme& scheme = plan_->problem.skeleton;
  const bool held_before = scheme.update == StressUpdate::usf;
  const double mixed = !held_before ? 0 : scheme.transfer == Transfer::apic ? 1 : scheme.pic;
  const Vector<dim> carried = mixed > 0 ? momentum() : Vector<dim>{};
  for (int a = 0; a < dim; ++a) {
    const double *inner = (*inner_)[a], *loaded = (*loaded_)[a], *v = (*node_velocity_)[a], *at = (*acceleration_)[a];
    const auto [pushed, reacted, seen] = sum_over<3>(cycle_->active->runs(), [&](const auto& here) {
      const auto m = here(mass), all = here(loaded);
      using Number = std::decay_t<decltype(m)>;
      return std::array<Number, 3>{all - here(inner), m * here(at) - all, m * here(v)};
    });
    (*sums_)[impulse + a][0] += dt * pushed;
    (*sums_)[reaction + a][0] += dt * reacted;
    if (mixed > 0) (*sums_)[reaction + a][0] += mixed * (seen - carried[a]);
  }
}

template <int dim>
Vector<dim> MotionLedger<dim>::momentum() const {
  Vector<dim> sum{};
  for (const Block& block : plan_->fields.points.blocks())
    for (int a = 0; a < dim; ++a) {
      double part = 0;
      for (std::size_t p = block.first; p < block.first + block.count; ++p) part += (*mass_)[0][p] * (*velocity_)[a][p];
      sum[a] += part;
    }
  return sum;
}

template <int dim>
double MotionLedger<dim>::motion() const {
  return over_points(plan_->fields.points,
                     [this](std::size_t p) { return (*mass_)[0][p] * length<dim>(at<dim>(*velocity_, p)); });
}

template <int dim>
double MotionLedger<dim>::potential_energy() const {
  // Less what points were lifted by when periodic sides handed them on: they go on falling as if they had not been.
  return over_points(plan_->fields.points,
                     [this](std::size_t p) {
                       return -(*mass_)[0][p] * dot<dim>(plan_->problem.gravity, at<dim>(*position_, p));
                     }) -
         (*migrated_)[migration_lifted][0];
}

template <int dim>
double MotionLedger<dim>::brought(int entry) const {
  return brought_ == nullptr ? 0 : (*brought_)[entry][0];
}

template <int dim>
void MotionLedger<dim>::record(double time, meshes::FieldHistory& history) const {
  const Column& sums = *sums_;
  meshes::MotionRow row;
  row.time = time;
  row.kinetic = kinetic_energy(plan_->fields.points, *mass_, *velocity_);
  row.stress_work = sums[stress_work][0];
  row.load_work = sums[load_work][0];
  row.resistance = sums[resistance][0];
  const double potential = potential_energy() - brought(0);
  row.drift = row.kinetic + potential + row.stress_work - row.load_work - row.resistance - sums[first_energy][0];
  row.potential = potential;
  row.motion = motion();
  const Vector<dim> now = momentum();
  for (int a = 0; a < dim; ++a) {
    const auto k = static_cast<std::size_t>(a);
    row.momentum[k] = now[a];
    row.impulse[k] = sums[impulse + a][0];
    row.reaction[k] = sums[reaction + a][0];
    row.momentum_drift[k] = now[a] - sums[first + a][0] - row.impulse[k] - row.reaction[k] - brought(1 + a);
  }
  history.motion.push_back(row);
}

template class MotionLedger<2>;
template class MotionLedger<3>;

}  // namespace wetfront::mpm
