#include "mpm/coupling/relaxation.h"

#include "mpm/coupling/skeleton_failed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace wetfront::mpm {

namespace {

/// An elastic correction costs one cycle and is exact for what is elastic: it goes on beyond the wanted ratio to here,
/// so that the split between flow and skeleton sees strains without noise.
constexpr double elastic_ratio = 1e-9;
/// Corrections that do not reduce the imbalance by this much per cycle are left to damped motion, or have reached
/// round-off.
constexpr double least_gain = 0.5;
/// A correction moves no node further than this part of a cell: strains stay increments.
constexpr double farthest = 0.2;
/// Fraction of the stable step: time means nothing here, only stability.
constexpr double safety = 0.8;
/// Cells along the longest axis for which Relaxation::most_iterations is meant, and the fewest iterations allowed.
constexpr double cells_of_cap = 100;
constexpr long fewest = 500;
/// Motion in a window of StallWatch, over FailureCriterion::displacement, that is no creep: at this pace the criterion
/// is beyond any number of iterations.
constexpr double no_creep = 0.01;

}  // namespace

template <int dim>
class Relaxer<dim>::Listener : public NodalCondition<dim> {
 public:
  Listener(const Column& force, Column& kept) : force_(force), kept_(kept) {}
  void see_force() override { std::ranges::copy(force_.values(), kept_.values().begin()); }

 private:
  const Column& force_;
  Column& kept_;
};

template <int dim>
Relaxer<dim>::Relaxer(StagePlan<dim>& plan, std::shared_ptr<SkeletonCycle<dim>> cycle)
    : plan_(plan), cycle_(std::move(cycle)) {
  const std::string force = dim == 2 ? "N/m" : "N";
  force_ = &plan.require_on_nodes("force");
  node_mass_ = &plan.require_on_nodes("mass");
  node_velocity_ = &plan.require_on_nodes("velocity");
  acceleration_ = &plan.require_on_nodes("acceleration");
  displacement_ = &plan.require_on_nodes("displacement");
  velocity_ = &plan.require_on_points("velocity");
  if (plan.problem.skeleton.transfer == Transfer::apic) affine_ = &plan.require_on_points("affine velocity");
  correction_ = &plan.provide_on_nodes({"elastic correction", "du", "m", dim, Lifetime::step});
  unbalanced_ = &plan.provide_on_nodes({"out of balance", "f", force, dim, Lifetime::step});
  cycle_->conditions.push_back(std::make_unique<Listener>(*force_, *unbalanced_));
  // Sides that move, slide or are tied are not in the elastic stiffness: damped motion knows them.
  elastic_possible_ = std::ranges::all_of(plan.problem.skeleton_boundary,
                                          [](const auto& b) { return std::holds_alternative<Traction>(b); }) &&
                      plan.problem.skeleton.shape == ShapeFunctions::linear &&
                      plan.fields.grid.node_count() * dim <= ElasticSolve<dim>::most_unknowns;
  shortest_ = std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < plan.fields.grid.cell_count(); ++cell)
    shortest_ = std::min(shortest_, plan.fields.grid.smallest_altitude(cell));
  Vector<dim> low = plan.fields.grid.node(0), high = low;
  for (std::size_t i = 0; i < plan.fields.grid.node_count(); ++i)
    for (int a = 0; a < dim; ++a) {
      low[a] = std::min(low[a], plan.fields.grid.node(static_cast<int>(i))[a]);
      high[a] = std::max(high[a], plan.fields.grid.node(static_cast<int>(i))[a]);
    }
  double longest = 0;
  for (int a = 0; a < dim; ++a) longest = std::max(longest, high[a] - low[a]);
  const double cells = longest / shortest_, most = static_cast<double>(plan.stage.relaxation.most_iterations);
  most_iterations_ = std::max(fewest, static_cast<long>(most * cells / cells_of_cap));
  crossing_ = 1 + static_cast<long>(cells * std::sqrt(static_cast<double>(dim)) / safety);
}

template <int dim>
void Relaxer<dim>::clear_velocities() {
  velocity_->fill(0);
  if (affine_ != nullptr) affine_->fill(0);
}

/// Forces that conditions hold (a base on which the body rests) are not out of balance: what they leave of f is m a.
template <int dim>
double Relaxer<dim>::imbalance() {
  double free = 0, held = 0, weight = 0;
  for (int a = 0; a < dim; ++a) {
    const auto& fixed = cycle_->fixed[static_cast<std::size_t>(a)];
    const double g = std::abs(plan_.problem.gravity[static_cast<std::size_t>(a)]);
    for (std::size_t i = 0; i < node_mass_->size(); ++i) {
      const double mass = (*node_mass_)[0][i], force = std::abs((*unbalanced_)[a][i]);
      if (!(mass > 0)) continue;
      weight += mass * g;
      if (fixed[i] != 0) {
        held += force;
        continue;
      }
      const double left = mass * std::abs((*acceleration_)[a][i]);
      const bool limited = left < 0.99 * (1 - cycle_->damping) * force;
      free += limited ? left : force;
      held += limited ? force - left : 0;
    }
  }
  // A body that bears nothing in the end (water that pushes from within) is measured against what began to move it.
  strongest_ = std::max(strongest_, free);
  const double size = std::max({held, weight, strongest_});
  return size > 0 ? free / size : 0;
}

template <int dim>
double Relaxer<dim>::kinetic_energy() const {
  double energy = 0;
  for (int a = 0; a < dim; ++a)
    for (std::size_t i = 0; i < node_mass_->size(); ++i)
      energy += 0.5 * (*node_mass_)[0][i] * (*node_velocity_)[a][i] * (*node_velocity_)[a][i];
  return energy;
}

template <int dim>
std::vector<double> Relaxer<dim>::ways(const std::vector<double>& since) const {
  const std::size_t nodes = displacement_->size();
  std::vector<double> all;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (!((*node_mass_)[0][i] > 0)) continue;
    Vector<dim> d{};
    for (int a = 0; a < dim; ++a) d[a] = (*displacement_)[a][i] - since[static_cast<std::size_t>(a) * nodes + i];
    all.push_back(length<dim>(d));
  }
  return all;
}

template <int dim>
double Relaxer<dim>::moved(const std::vector<double>& since) const {
  double most = 0;
  for (const double way : ways(since)) most = std::max(most, way);
  return most;
}

/// A slide moves many nodes; a corner with a sliver of soil moves first and says nothing.
template <int dim>
double Relaxer<dim>::slid(const std::vector<double>& since) const {
  constexpr double below = 0.95;  // of the nodes move less
  std::vector<double> all = ways(since);
  if (all.empty()) return 0;
  const auto place = all.begin() + static_cast<std::ptrdiff_t>(below * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), place, all.end());
  return *place;
}

/// One elastic correction; false when there is no stiffness to do it with.
template <int dim>
bool Relaxer<dim>::correct() {
  if (elastic_ == nullptr) {
    std::array<std::vector<int>, 3> fixed;
    for (std::size_t a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < cycle_->fixed[a].size(); ++i)
        if (cycle_->fixed[a][i] != 0) fixed[a].push_back(static_cast<int>(i));
    elastic_ = std::make_unique<ElasticSolve<dim>>(plan_, fixed);
  }
  if (!factorised_) factorised_ = elastic_->factorise();
  if (!factorised_) return false;
  elastic_->solve(*unbalanced_, *correction_);
  double most = 0;
  for (double u : correction_->values()) most = std::max(most, std::abs(u));
  if (!std::isfinite(most)) return false;
  const double scale = std::min(1.0, farthest * shortest_ / std::max(most, 1e-300));
  const auto u = correction_->values(), total = displacement_->values(), v = node_velocity_->values();
  for (std::size_t k = 0; k < u.size(); ++k) {
    total[k] += scale * u[k];
    v[k] = scale * u[k] / cycle_->dt;
  }
  cycle_->move->run();
  cycle_->migrate->run();
  return true;
}

template <int dim>
void Relaxer<dim>::move_by_cycle() {
  for (Kernel* kernel : {cycle_->points, cycle_->velocity, cycle_->move, cycle_->migrate}) kernel->run();
}

/// A step without motion brings stress back to the yield surface (elastic corrections and damped motion begin with the
/// forces of the stress that is there).
template <int dim>
typename Relaxer<dim>::Outcome Relaxer<dim>::run_weakened() {
  cycle_->dt = safety * cycle_->stable_step();
  clear_velocities();
  cycle_->gather->run();  // who is where
  node_velocity_->fill(0);
  cycle_->move->run();
  cycle_->migrate->run();
  begin_step();
  // A weakened body may creep for long before it slides: StallWatch leaves it alone.
  return relax(most_iterations_);
}

template <int dim>
typename Relaxer<dim>::Outcome Relaxer<dim>::relax(long stall_window) {
  const double wanted = plan_.stage.relaxation.unbalanced_ratio;
  cycle_->dt = safety * cycle_->stable_step();
  cycle_->damping = plan_.stage.relaxation.damping;
  start_.assign(displacement_->values().begin(), displacement_->values().end());
  energies_ = {};
  strongest_ = 0;
  stall_.begin(stall_window, no_creep * plan_.stage.failure.displacement);
  clear_velocities();
  Outcome outcome;
  bool elastic = elastic_possible_;
  double before = std::numeric_limits<double>::infinity();
  while (true) {
    cycle_->gather->run();
    cycle_->accelerate->run();
    outcome.ratio = imbalance();
    if (!std::isfinite(outcome.ratio)) give_up(outcome);
    const bool gains = outcome.ratio <= least_gain * before;
    const bool settled = std::ranges::all_of(cycle_->conditions, [](const auto& one) { return one->settled(); });
    if (settled && (outcome.ratio <= elastic_ratio || (outcome.ratio <= wanted && !(elastic && gains)))) break;
    if (plan_.stage.ends_with == StageEnd::failure) {
      look_for_failure(outcome);
      if (outcome.stalled) break;
    }
    if (outcome.iterations >= most_iterations_) give_up(outcome);
    if (elastic && !gains) elastic = false;
    before = outcome.ratio;
    if (elastic) elastic = correct();
    if (!elastic) {
      energies_[0] = std::max(energies_[0], kinetic_energy());
      if (outcome.iterations % crossing_ == 0) {
        std::copy_backward(energies_.begin(), energies_.end() - 1, energies_.end());
        energies_[0] = 0;
      }
      move_by_cycle();
    }
    ++outcome.iterations;
  }
  clear_velocities();
  outcome.displacement = moved(start_);
  return outcome;
}

template <int dim>
void Relaxer<dim>::look_for_failure(Outcome& outcome) {
  constexpr long every = 16;  // iterations: a cycle costs far more than this look, but for 16 of them it is nothing
  const FailureCriterion& criterion = plan_.stage.failure;
  const bool out_of_iterations = outcome.iterations >= most_iterations_;
  if (!out_of_iterations && outcome.iterations % every != 0) return;
  const double far = step_start_.empty() ? 0 : slid(step_start_);
  const bool no_nearer = stall_.stalled(outcome.iterations, outcome.ratio, far) || out_of_iterations;
  outcome.stalled = no_nearer && outcome.ratio <= criterion.unbalanced_ratio;
  if (far <= criterion.displacement && (!out_of_iterations || outcome.stalled)) return;
  char text[240];
  std::snprintf(
      text, sizeof text,
      "no equilibrium: a twentieth of the nodes have moved more than %.3g m (limit %.3g m), %.3g of the forces are out "
      "of balance (limit %.3g) after %ld iterations (limit %ld)",
      far, criterion.displacement, outcome.ratio, criterion.unbalanced_ratio, outcome.iterations, most_iterations_);
  throw SkeletonFailed(text);
}

template <int dim>
void Relaxer<dim>::give_up(const Outcome& outcome) const {
  char text[400];
  const bool grows = energies_[1] > energies_[2] && energies_[2] > energies_[3];
  std::snprintf(text, sizeof text,
                "the skeleton does not come to rest: after %ld iterations %.3g of the forces are out of balance (an "
                "equilibrium has at most %.3g), the farthest node has moved %.3g m and the kinetic energy %s over the "
                "last three wave crossings. %s",
                outcome.iterations, outcome.ratio, plan_.stage.relaxation.unbalanced_ratio, moved(start_),
                grows ? "has grown" : "has not grown",
                grows ? "It has failed: go on with a dynamic stage"
                      : "Allow more iterations (most_iterations), or go on with a dynamic stage");
  throw StepFailed(text);
}

void RelaxationCounts::tell(meshes::FieldHistory& history) {
  history.counters["relaxations"] += static_cast<double>(std::exchange(relaxations, 0));
  history.counters["cycles of relaxation"] += static_cast<double>(std::exchange(iterations, 0));
  if (stalls > 0) history.counters["stalled relaxations"] += static_cast<double>(std::exchange(stalls, 0));
  const auto raise = [&history](const char* name, double& worst) {
    double& known = history.counters[name];
    known = std::max(known, std::exchange(worst, 0));
  };
  raise("out of balance at the worst", ratio);
  raise("largest displacement of one relaxation [m]", displacement);
}

template <int dim>
void add_relaxation(StagePlan<dim>& plan, std::function<typename Relaxer<dim>::Outcome()> relax) {
  auto counts = std::make_shared<RelaxationCounts>();
  plan.add(Phase::accelerate, "relaxation", [relax = std::move(relax), counts] { counts->add(relax()); });
  plan.at_record([counts](double, meshes::FieldHistory& history) { counts->tell(history); });
}

template <int dim>
void QuasiStaticMotion<dim>::join(StagePlan<dim>& plan) {
  relaxer_ = std::make_unique<Relaxer<dim>>(plan, cycle_);
  add_relaxation<dim>(plan, [this] {
    relaxer_->begin_step();
    return relaxer_->run();
  });
}

template class Relaxer<2>;
template class Relaxer<3>;
template void add_relaxation<2>(StagePlan<2>&, std::function<Relaxer<2>::Outcome()>);
template void add_relaxation<3>(StagePlan<3>&, std::function<Relaxer<3>::Outcome()>);
template class QuasiStaticMotion<2>;
template class QuasiStaticMotion<3>;

}  // namespace wetfront::mpm
