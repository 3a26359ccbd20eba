#include "mpm/seepage/seepage_step.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace wetfront::mpm {

namespace {

// Newton's method ends when every nodal balance closes to this fraction of the node's pore volume: three orders above
// the round-off of W, and small enough that a run of 1e4 steps still balances to 1e-8 of the rain.
constexpr double newton_tolerance = 1e-12;
// Saturated nodes on very fine meshes: dt K / h^2 amplifies the round-off of p above newton_tolerance. An update this
// small relative to the pressure scale is round-off, provided that the balance closes to stalled_tolerance.
constexpr double stalled_update = 1e-13, stalled_tolerance = 1e-9;
// So is a balance closed to `round_off` that three more iterations do not halve: slivers of a moving body stand beside
// nodes without soil, whose pressures of 1e5 Pa leave 1e-11 Pa in what their film sees.
constexpr std::size_t stalled_iterations = 3;
constexpr double round_off = 1e-10;
constexpr int most_iterations = 25;
constexpr int most_backtracks = 8;
// Pieces of a surface inside cells share nodes: where one begins to refuse water, what relieves it raises the next one
// over its kink, far out of balance for next to no pressure, and no length of the step is better than none. The whole
// step is taken then: the next iteration knows both films (the watchdog of Chamberlain, Powell, Lemarechal & Pedersen
// 1982).
constexpr int most_leaps = 6;
// Growth of at most 2 keeps the variable-step BDF2 stable (its limit is 1 + sqrt 2).
constexpr double most_growth = 2.0, most_shrinkage = 0.2, safety = 0.9;
// First step after a break: no node's saturation may change by more than this in an explicit step.
constexpr double first_saturation_change = 1e-4;
constexpr double smallest_step = 1e-9;  // s
/// Failed solves after which a step of given length is told to crawl: each leaves two parts of half the length.
constexpr long most_failures_of_cover = 500;
// Steps known behind a break in a deforming skeleton: -3 before the load is answered, -2 after.
constexpr double step_after_jump = -2;
// One jump is over in a step or two; more than this one behind the other are a tolerance that cannot be met.
constexpr int most_shortest_in_a_row = 20;
// Where flow stops at once its momentum presses the harder the shorter the step that holds it: rho g L (w/K_s) tau/dt,
// tau the time in which drag stops water. Error control asks no shorter ones than this many tau, which leave 1e-4 of
// the head.
constexpr double drag_times = 1e4;
// A matrix whose entries sum to less than this part of its diagonal leaves the level of the pressure open.
constexpr double undetermined = 1e-13;

}  // namespace

template <int dim>
SeepageStep<dim>::SeepageStep(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns,
                              double pressure_scale)
    : plan_(plan), water_(water), c_(columns), pressure_scale_(pressure_scale) {
  level_may_be_open_ = std::ranges::all_of(plan.problem.soils, [&](const Soil& soil) {
    return soil.storage ? *soil.storage == 0 : std::isinf(plan.problem.water->bulk_modulus);
  });
  shortest_controlled_ = smallest_step;
  // Pressures of full pores shake with a skeleton that yields: near failure no shorter step would be smoother.
  if (plan.stage.ends_with == StageEnd::failure) shortest_controlled_ = plan.stage.failure.shortest_step;
  if (c_.flux != nullptr)
    for (const Soil& soil : plan.problem.soils) {
      const Water& water_in_it = *plan.problem.water;
      const double tau = water_in_it.density * soil.intrinsic_permeability / (water_in_it.viscosity * soil.porosity);
      shortest_controlled_ = std::max(shortest_controlled_, drag_times * tau);
    }
  linear_solve_ = &plan.add_iterated(Phase::pressure, "linear solve",
                                     [this] { solved_ = water_.matrix->solve(balance_, update_); });
}

template <int dim>
void SeepageStep<dim>::prepare() {
  const std::size_t nodes = c_.pressure->size();
  balance_.assign(nodes, 0.0);
  update_.assign(nodes, 0.0);
  start_.assign(nodes, 0.0);
  pore_volume_.assign(nodes, 0.0);
  for (int region = 0; region < c_.pore_volume->spec().components; ++region)
    for (std::size_t i = 0; i < nodes; ++i) pore_volume_[i] += (*c_.pore_volume)[region][i];
  active_.clear();
  for (std::size_t i = 0; i < nodes; ++i)
    if (pore_volume_[i] > 0) active_.push_back(static_cast<int>(i));
}

template <int dim>
double SeepageStep<dim>::proposal() const {
  return (*c_.steps)[step_proposal][0];
}

template <int dim>
typename SeepageStep<dim>::Formula SeepageStep<dim>::formula(double dt) const {
  const double h1 = (*c_.steps)[step_last][0], h2 = (*c_.steps)[step_before][0];
  const double history = (*c_.steps)[step_history][0];
  if (history < 1) return {Bdf2Weights{}, StepPredictor::constant()};
  // The inertia of the liquid is integrated by backward Euler, so the rest is too.
  if (plan_.stage.integrator == TimeIntegrator::backward_euler || c_.flux != nullptr)
    return {Bdf2Weights{}, StepPredictor::line(dt, h1)};
  if (history < 2) return {Bdf2Weights::of(dt / h1), StepPredictor::line(dt, h1)};
  return {Bdf2Weights::of(dt / h1), StepPredictor::parabola(dt, h1, h2)};
}

template <int dim>
void SeepageStep<dim>::predict(const Formula& formula) {
  const StepPredictor& w = formula.predictor;
  const double *p = (*c_.pressure)[0], *before = (*c_.pressure_before)[0], *earlier = (*c_.pressure_earlier)[0];
  double* trial = (*water_.trial)[0];
  for (std::size_t i = 0; i < start_.size(); ++i)
    trial[i] = start_[i] = w.last * p[i] + w.before * before[i] + w.earlier * earlier[i];
  for (const auto& held : water_.held) trial[held.node] = held.pressure;
  water_.ties.copy_pressure(trial);
}

template <int dim>
void SeepageStep<dim>::evaluate() {
  water_.stored->fill(0);
  water_.capacity->fill(0);
  water_.inflow->fill(0);
  water_.outflow->fill(0);
  for (auto& sum : water_.cumulative) sum.rate->fill(0);
  std::ranges::fill(water_.matrix->values(), 0.0);
  for (Kernel* term : water_.terms) term->run();
}

template <int dim>
double SeepageStep<dim>::residual(const Bdf2Weights& weights, double dt) {
  water_.dt = dt;
  evaluate();
  const double *now = (*water_.stored)[0], *last = (*c_.stored)[0], *before = (*c_.stored_before)[0];
  const double* inflow = (*water_.inflow)[0];
  std::ranges::fill(balance_, 0.0);
  for (int i : active_) {
    const auto k = static_cast<std::size_t>(i);
    balance_[k] = -(weights.now * now[k] + weights.last * last[k] + weights.before * before[k] - dt * inflow[k]);
  }
  water_.ties.sum_balance(balance_);
  for (const auto& held : water_.held) balance_[static_cast<std::size_t>(held.node)] = 0;
  double worst = 0;
  for (int i : active_) {
    const double relative = std::abs(balance_[static_cast<std::size_t>(i)]) / pore_volume_[static_cast<std::size_t>(i)];
    if (!(relative <= worst) && !std::isnan(worst)) worst = relative;  // keeps NaN
  }
  return worst;
}

template <int dim>
bool SeepageStep<dim>::newton(const Bdf2Weights& weights, double dt) {
  residuals_.assign(1, residual(weights, dt));
  int leaps = 0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    // At least one iteration: a guess within the tolerance would lose the rain of very small steps.
    if (iteration > 0 && residuals_.back() <= newton_tolerance) return true;
    for (double& value : water_.matrix->values()) value *= -dt;
    const double* capacity = (*water_.capacity)[0];
    for (int i : active_) water_.add_slope(i, weights.now * capacity[i]);
    water_.ties.sum_rows(*water_.matrix);
    for (std::size_t i = 0; i < pore_volume_.size(); ++i)
      if (!(pore_volume_[i] > 0)) water_.matrix->make_identity_row(static_cast<int>(i));
    if (level_may_be_open_ && water_.held.empty()) pin_open_level();
    for (const auto& held : water_.held) water_.matrix->make_identity_row(held.node);
    ++newton_iterations;
    linear_solve_->run();
    if (!solved_) return false;
    if (!line_search(weights, dt)) {
      if (++leaps > most_leaps) return false;
      take(1);
      residuals_.push_back(residual(weights, dt));
    }
    double largest = 0;
    for (double u : update_) largest = std::max(largest, std::abs(u));
    if (largest <= stalled_update * pressure_scale_ && residuals_.back() <= stalled_tolerance) return true;
    if (residuals_.size() > stalled_iterations && residuals_.back() <= round_off &&
        residuals_.back() > 0.5 * residuals_[residuals_.size() - 1 - stalled_iterations])
      return true;
  }
  return false;
}

template <int dim>
void SeepageStep<dim>::tell_window(double begin, double end) const {
  for (const auto& tell : water_.before_solve) tell(begin, end);
}

/// Lets a deforming skeleton follow, and the flow that, until they agree.
template <int dim>
bool SeepageStep<dim>::couple(const Bdf2Weights& weights, double dt) {
  if (!water_.settle) return true;
  // Loads on the skeleton are those of the end of the step that is being tried.
  Clock& clock = plan_.clock;
  const double end = std::exchange(clock.end, dt < clock.dt ? clock.time + dt : clock.end);
  for (int pass = 0; water_.settle(pass); ++pass) {
    // The skeleton may have another surface now, and what falls on it has to be told where.
    tell_window(clock.time, clock.time + dt);
    for (const auto& held : water_.held) (*water_.trial)[0][held.node] = held.pressure;
    water_.ties.copy_pressure((*water_.trial)[0]);
    if (!newton(weights, dt)) {
      clock.end = end;
      return false;
    }
  }
  return true;
}

/// A full box of incompressible water without an outlet: fluxes balance at any level of the pressure, and the matrix
/// has no inverse. One node is kept from moving, which changes nothing where the box is in balance; where water is
/// pressed into it no solution exists and none is found.
template <int dim>
void SeepageStep<dim>::pin_open_level() {
  double sum = 0, diagonal = 0;
  for (double value : water_.matrix->values()) sum += value;
  for (int i : active_)
    diagonal += std::abs(water_.matrix->values()[static_cast<std::size_t>(water_.matrix->slot(i, i))]);
  if (std::abs(sum) > undetermined * diagonal) return;
  water_.add_slope(active_.front(), diagonal / static_cast<double>(active_.size()));
}

template <int dim>
void SeepageStep<dim>::take(double length) {
  double* trial = (*water_.trial)[0];
  for (std::size_t i = 0; i < start_.size(); ++i) trial[i] = start_[i] + length * update_[i];
  for (const auto& limit : water_.limits) limit(start_, trial);
}

template <int dim>
bool SeepageStep<dim>::line_search(const Bdf2Weights& weights, double dt) {
  double* trial = (*water_.trial)[0];
  std::copy_n(trial, start_.size(), start_.begin());
  const double before = residuals_.back();
  double length = 1;
  for (int k = 0; k < most_backtracks; ++k, length /= 2) {
    take(length);
    residuals_.push_back(residual(weights, dt));
    if (residuals_.back() <= (1 - 1e-4 * length) * before || residuals_.back() <= stalled_tolerance) return true;
  }
  return false;
}

template <int dim>
double SeepageStep<dim>::local_error(const StepPredictor& w) const {
  const double *p = (*c_.pressure)[0], *before = (*c_.pressure_before)[0], *earlier = (*c_.pressure_earlier)[0];
  const double* trial = (*water_.trial)[0];
  double square = 0, size = 0, volume = 0;
  for (int node : active_) {
    const auto i = static_cast<std::size_t>(node);
    const double error =
        w.error_fraction * (trial[i] - (w.last * p[i] + w.before * before[i] + w.earlier * earlier[i]));
    square += pore_volume_[i] * error * error;
    size += pore_volume_[i] * trial[i] * trial[i];
    volume += pore_volume_[i];
  }
  return std::sqrt(square / volume) / (std::sqrt(size / volume) + pressure_scale_);
}

template <int dim>
double SeepageStep<dim>::first_step() {
  std::ranges::copy(c_.pressure->values(), water_.trial->values().begin());
  for (const auto& held : water_.held) (*water_.trial)[0][held.node] = held.pressure;
  water_.ties.copy_pressure((*water_.trial)[0]);
  water_.dt = plan_.stage.end_time - plan_.begin_time();
  evaluate();
  double step = plan_.stage.end_time - plan_.begin_time();
  for (int node : active_) {
    const auto i = static_cast<std::size_t>(node);
    step = std::min(step, first_saturation_change * pore_volume_[i] / std::abs((*water_.inflow)[0][i]));
  }
  return std::max(step, smallest_step);
}

template <int dim>
void SeepageStep<dim>::run() {
  Clock& clock = plan_.clock;
  double dt = clock.dt;
  if (clock.broken) {
    // Pressures may jump at a break (at once where water cannot be compressed): neither the step that holds the jump
    // nor the one behind it is measured against an extrapolation.
    (*c_.steps)[step_history][0] = -1;
    tell_window(clock.time, clock.time + smallest_step);
    // A load that jumps is answered at once, by the undrained skeleton; only then does water begin to flow.
    if (water_.settle) {
      (*c_.steps)[step_history][0] = step_after_jump - 1;
      dt = std::min(dt, smallest_step);
    } else {
      dt = std::min(dt, first_step());
    }
  } else if ((*c_.steps)[step_history][0] == step_after_jump) {
    // A run that was cut here has not been told yet what falls.
    tell_window(clock.time, clock.time + dt);
    dt = std::min(dt, first_step());
  }
  const double tolerance = plan_.stage.time_tolerance;
  while (true) {
    const Formula f = formula(dt);
    tell_window(clock.time, clock.time + dt);
    predict(f);
    double factor = 0.5;
    if (newton(f.weights, dt)) {
      const double error = local_error(f.predictor) / tolerance;
      factor = std::clamp(safety * std::pow(std::max(error, 1e-12), -1.0 / (f.predictor.order + 1)), most_shrinkage,
                          most_growth);
      // No step is short enough for a pressure that jumps (the last pore of incompressible soil fills): the shortest
      // one holds the jump, unmeasured, and history begins anew behind it.
      const bool jumps = error > 1 && dt * factor < shortest_controlled_;
      const bool measured = f.predictor.error_fraction > 0;
      if (measured && error <= 1) shortest_in_a_row_ = 0;
      if (jumps && dt * factor < smallest_step) ++shortest_in_a_row_;
      if (shortest_in_a_row_ > most_shortest_in_a_row) give_up(dt);
      const bool good = error <= 1 || jumps;
      if (good && couple(f.weights, dt)) {
        if (dt < clock.dt) clock.end = clock.time + dt;
        clock.dt = dt;
        accept(f, dt);
        if (jumps) {
          (*c_.steps)[step_history][0] = 0;
          ++jumps_taken;
          factor = 1;
        }
        const bool answered = (*c_.steps)[step_history][0] == step_after_jump;
        (*c_.steps)[step_proposal][0] = answered ? plan_.stage.end_time - plan_.begin_time() : dt * factor;
        return;
      }
      if (good) factor = 0.5;
      ++rejected_steps;
    } else {
      ++failed_solves;
    }
    if (dt * factor < smallest_step) give_up(dt);
    dt *= factor;
  }
}

template <int dim>
void SeepageStep<dim>::cover_part(double begin, double end) {
  const Formula euler{Bdf2Weights{}, StepPredictor::constant()};
  tell_window(begin, end);
  predict(euler);
  if (newton(euler.weights, end - begin)) return accept(euler, end - begin);
  ++failed_solves;
  if (end - begin < smallest_step || failed_solves > most_failed_) give_up(end - begin);
  const double middle = begin + 0.5 * (end - begin);
  cover_part(begin, middle);
  cover_part(middle, end);
}

template <int dim>
void SeepageStep<dim>::cover() {
  const auto kept = [](const Column& column) {
    return std::vector<double>(column.values().begin(), column.values().end());
  };
  const std::vector<double> pressure = kept(*c_.pressure), stored = kept(*c_.stored);
  most_failed_ = failed_solves + most_failures_of_cover;
  cover_part(plan_.clock.time, plan_.clock.end);
  // What was gained is told against the beginning of the whole.
  std::ranges::copy(pressure, c_.pressure_before->values().begin());
  std::ranges::copy(stored, c_.stored_before->values().begin());
  (*c_.steps)[step_history][0] = 0;
}

template <int dim>
void SeepageStep<dim>::accept(const Formula& f, double dt) {
  const Bdf2Weights& w = f.weights;
  const auto shift = [](Column& from, Column& to) { std::ranges::copy(from.values(), to.values().begin()); };
  for (Kernel* kernel : water_.accepted) kernel->run();
  const double *now = (*water_.stored)[0], *last = (*c_.stored)[0], *before = (*c_.stored_before)[0];
  // What a held node needs beyond the flow through the soil comes in through the boundary.
  for (const auto& held : water_.held) {
    const auto i = static_cast<std::size_t>(held.node);
    const double out = (*water_.inflow)[0][i] - (w.now * now[i] + w.last * last[i] + w.before * before[i]) / dt;
    (*water_.outflow)[0][i] += out;
    if (held.condition >= 0) water_.add_to_side(held.condition, side_outflow, out);
  }
  for (auto& sum : water_.cumulative) {
    const auto rate = sum.rate->values(), total = sum.total->values(), earlier = sum.before->values();
    for (std::size_t i = 0; i < rate.size(); ++i) {
      const double next = (dt * rate[i] - w.last * total[i] - w.before * earlier[i]) / w.now;
      earlier[i] = total[i];
      total[i] = next;
    }
  }
  shift(*c_.pressure_before, *c_.pressure_earlier);
  shift(*c_.pressure, *c_.pressure_before);
  shift(*water_.trial, *c_.pressure);
  shift(*c_.stored, *c_.stored_before);
  shift(*water_.stored, *c_.stored);
  double* memory = (*c_.steps)[0];
  memory[step_before] = memory[step_last];
  memory[step_last] = dt;
  memory[step_history] = std::min(2.0, memory[step_history] + 1);
}

template <int dim>
void SeepageStep<dim>::give_up(double dt) const {
  int worst = active_.front();
  for (int i : active_)
    if (std::abs(balance_[static_cast<std::size_t>(i)]) > std::abs(balance_[static_cast<std::size_t>(worst)]))
      worst = i;
  const auto& x = plan_.fields.grid.node(worst);
  char text[240];
  std::snprintf(text, sizeof text,
                "no step down to %.2g s converges or meets the tolerance; worst balance at node %d (x = %.4g, %.4g m); "
                "residuals of the last try:",
                dt, worst, x[0], x[1]);
  std::string message = text;
  for (double r : residuals_) {
    std::snprintf(text, sizeof text, " %.2g", r);
    message += text;
  }
  throw StepFailed(message);
}

template class SeepageStep<2>;
template class SeepageStep<3>;

}  // namespace wetfront::mpm
