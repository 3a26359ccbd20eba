#include "fem_reference/stage/stage_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::fem_reference {
namespace {

// Quadratic convergence needs 2-5 iterations; what takes longer is cheaper with a smaller step, unless it is the steady
// linear convergence out of a flat point (W ~ |psi|^n at saturation), which no step size cures.
constexpr int patience = 15, max_iterations = 80;
constexpr double steady_decrease = 0.7;

bool stalls(const std::vector<double>& residuals) {
  const std::size_t n = residuals.size();
  return n > max_iterations || (n > patience && residuals[n - 1] > steady_decrease * residuals[n - 2]);
}

/// Newton's steps are taken whole; where they have long gone in circles (K with a vertical tangent), half as far each
/// time that the residual has not fallen by half, and twice as far when it has.
double share_of_step(const std::vector<double>& residuals, double share) {
  const std::size_t n = residuals.size();
  if (n <= patience / 2) return 1;
  return residuals[n - 1] > 0.5 * residuals[n - 2] ? std::max(0.125, 0.5 * share) : std::min(1.0, 2 * share);
}

}  // namespace

StageKernel::StageKernel(FlowOperator& flow, Boundary& boundary, double newton_tolerance)
    : flow_(flow),
      boundary_(boundary),
      limit_(flow),
      newton_tolerance_(newton_tolerance),
      flat_tops_(flat_tops(flow.laws(), newton_tolerance)),
      matrix_(flow.pattern()),
      linear_(make_linear_solver(matrix_, {flow.volume(), newton_tolerance}, flow.space().ranks)) {
  const std::size_t n = flow.space().dof_count;
  mode_.assign(boundary.held().size(), Mode::free);
  released_.assign(boundary.held().size(), 0);
  residual_.assign(n, 0);
  rounding_.assign(n, 0);
}

bool StageKernel::is_held(std::size_t h) const {
  return boundary_.held()[h].kind == HeldDof::Kind::head || mode_[h] == Mode::ponded || mode_[h] == Mode::dry_held;
}

double StageKernel::held_head(std::size_t h) const {
  const HeldDof& held = boundary_.held()[h];
  return held.kind == HeldDof::Kind::rain && mode_[h] == Mode::dry_held ? held.lowest : held.head;
}

double StageKernel::offered(std::size_t h) const {
  const HeldDof& held = boundary_.held()[h];
  return mode_[h] == Mode::dry_free ? held.rain : held.rain - held.demand;
}

double StageKernel::tolerance(int dof) const {
  return newton_tolerance_ * flow_.volume()[dof] + rounding_[dof];
}

double StageKernel::open_head(int dof, double head) const {
  double widest = 0;
  for (const FlatTop& top : flat_tops_) {
    if (std::abs(head - top.full) < top.gap) return top.gap;
    widest = std::max(widest, top.gap);
  }
  const double capacity = flow_.capacity()[dof];
  return capacity > 0 ? std::min(widest, newton_tolerance_ / capacity) : 0;
}

double StageKernel::open_dry_head(int dof, double head, double water) const {
  const double capacity = flow_.capacity()[dof];
  return head < limit_.bend(dof) && capacity > 0 ? water / capacity : 0;
}

void StageKernel::evaluate(std::span<const double> head) {
  flow_.evaluate(head);
  ++evaluations;
}

void StageKernel::residual(std::span<const double> target, double tau) {
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    residual_[i] = flow_.volume()[i] * (flow_.water()[i] - target[i]) - tau * flow_.inflow()[i];
  }
  for (std::size_t h = 0; h < mode_.size(); ++h) residual_[boundary_.held()[h].dof] -= tau * offered(h);
}

// Released beyond the Newton tolerance only: otherwise rounding makes a neutral node chatter.
bool StageKernel::update_mode(std::size_t h, double tau, double head) {
  const HeldDof& held = boundary_.held()[h];
  double& row = residual_[held.dof];
  const Mode before = mode_[h];
  switch (before) {
    case Mode::ponded:
      if (row > tolerance(held.dof)) mode_[h] = Mode::free;
      break;
    case Mode::dry_held:
      if (row < -tolerance(held.dof)) mode_[h] = Mode::free;
      if (row > tau * held.demand + tolerance(held.dof)) {
        mode_[h] = Mode::dry_free;
        row -= tau * held.demand;
      }
      break;
    case Mode::dry_free:
      if (head > held.lowest) mode_[h] = Mode::dry_held;
      break;
    case Mode::free:
      if (head > held.head) mode_[h] = Mode::ponded;
      if (held.demand > 0 && head < held.lowest) mode_[h] = Mode::dry_held;
  }
  return mode_[h] != before;
}

// Held rows give the released water; their residual is then zero by definition. True when the set changed.
bool StageKernel::update_active_set(double tau, std::span<const double> head) {
  bool changed = false;
  for (std::size_t h = 0; h < released_.size(); ++h) {
    const HeldDof& held = boundary_.held()[h];
    const double row = residual_[held.dof];
    released_[h] = 0;
    if (held.kind == HeldDof::Kind::rain && update_mode(h, tau, head[held.dof])) {
      changed = true;
    } else if (held.kind == HeldDof::Kind::head) {
      released_[h] = -row / tau;
    } else if (mode_[h] == Mode::ponded) {
      released_[h] = std::max(0.0, -row / tau);
    } else if (mode_[h] == Mode::dry_held) {
      released_[h] = -std::clamp(row / tau, 0.0, held.demand);
    } else if (mode_[h] == Mode::dry_free) {
      released_[h] = -held.demand;
    }
    if (!is_held(h)) continue;
    if (head[held.dof] != held_head(h)) changed = true;  // the first guess may not know the given head
    residual_[held.dof] = 0;
  }
  return changed;
}

double StageKernel::worst_residual(int& dof, double& ratio) const {
  double worst = 0;
  ratio = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    const double r = std::abs(residual_[i]);
    if (!(r <= std::numeric_limits<double>::max())) {
      dof = static_cast<int>(i);
      ratio = r;
      return r;
    }
    ratio = std::max(ratio, r / tolerance(static_cast<int>(i)));
    if (r / flow_.volume()[i] >= worst) {
      worst = r / flow_.volume()[i];
      dof = static_cast<int>(i);
    }
  }
  return worst;
}

/// The worst residual of all ranks; the others are made theirs too.
double StageKernel::agree(bool& changed, double& ratio) const {
  const auto or_infinite = [](double x) { return std::isfinite(x) ? x : std::numeric_limits<double>::infinity(); };
  double values[] = {changed ? 1.0 : 0.0, or_infinite(ratio), or_infinite(failure_.worst)};
  flow_.space().ranks.max(values);
  changed = values[0] > 0;
  ratio = values[1];
  return values[2];
}

void StageKernel::hold_rows(std::span<const double> head) {
  for (std::size_t h = 0; h < mode_.size(); ++h) {
    if (!is_held(h)) continue;
    const HeldDof& held = boundary_.held()[h];
    for (int k = matrix_.row_start[held.dof]; k < matrix_.row_start[held.dof + 1]; ++k) {
      matrix_.value[k] = matrix_.column[k] == held.dof ? 1 : 0;
    }
    residual_[held.dof] = head[held.dof] - held_head(h);
  }
}

bool StageKernel::newton_step(double tau, std::span<double> head, double share) {
  flow_.assemble(tau, matrix_);
  constexpr double eps = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < matrix_.size(); ++i) {
    double scale = tau * flow_.passing()[i];
    for (int k = matrix_.row_start[i]; k < matrix_.row_start[i + 1]; ++k) {
      scale += std::abs(matrix_.value[k] * flow_.head()[matrix_.column[k]]);
    }
    rounding_[i] = 4 * eps * scale;
  }
  hold_rows(head);
  {
    const CostTimer timer(linear_solve_cost);
    if (!linear_->solve(matrix_, residual_)) return false;
  }
  for (std::size_t i = 0; i < head.size(); ++i) {
    head[i] = limit_.moved(static_cast<int>(i), head[i], -share * residual_[i]);
  }
  for (std::size_t h = 0; h < mode_.size(); ++h) {
    if (is_held(h)) head[boundary_.held()[h].dof] = held_head(h);  // exactly, not to rounding
  }
  return true;
}

bool StageKernel::solve(std::span<const double> target, double tau, std::span<double> head) {
  ++solves;
  failure_ = {};
  const std::vector<Mode> mode_before = mode_;
  std::fill(rounding_.begin(), rounding_.end(), 0.0);
  double share = 1;
  for (int iteration = 0;; ++iteration) {
    evaluate(head);
    residual(target, tau);
    bool changed = update_active_set(tau, head);
    double ratio = 0;
    failure_.worst = worst_residual(failure_.dof, ratio);
    failure_.head = head[failure_.dof];
    failure_.residuals.push_back(agree(changed, ratio));
    // The guess itself must be far better than that: a step so small that it changes less than the tolerance would
    // otherwise pass without doing anything, and its rain would be lost.
    if (!changed && ratio <= (iteration == 0 ? 1e-3 : 1)) return true;
    share = share_of_step(failure_.residuals, share);
    if (!std::isfinite(ratio)) {
      failure_.reason = "the residual is not a number";
    } else if (stalls(failure_.residuals)) {
      failure_.reason = "no convergence in " + std::to_string(iteration) + " Newton iterations";
    } else if (!newton_step(tau, head, share)) {
      failure_.reason = "the Jacobian is singular";
    }
    if (!failure_.reason.empty()) break;
    ++iterations;
  }
  ++failed_solves;
  mode_ = mode_before;
  return false;
}

std::vector<double> StageKernel::make_consistent(std::vector<double>& head) const {
  const std::vector<double> before = flow_.water_at(head);
  for (const HeldDof& held : boundary_.held()) {
    if (held.kind == HeldDof::Kind::head || head[held.dof] > held.head) head[held.dof] = held.head;
  }
  const std::vector<double> after = flow_.water_at(head);
  std::vector<double> taken(boundary_.condition_count(), 0.0);
  for (const HeldDof& held : boundary_.held()) {
    taken[held.condition] += flow_.volume()[held.dof] * (before[held.dof] - after[held.dof]);
  }
  return taken;
}

/// `row` is the inflow of a rain dof with all that is offered and demanded [m^dim/s].
StageKernel::Mode StageKernel::mode_of_rates(std::size_t h, double head, double row) const {
  const HeldDof& held = boundary_.held()[h];
  if (head >= held.head && row > 0) return Mode::ponded;
  if (held.demand == 0 || head > held.lowest || (head == held.lowest && row >= 0)) return Mode::free;
  return head == held.lowest && -row <= held.demand ? Mode::dry_held : Mode::dry_free;
}

std::vector<double> StageKernel::rates(std::span<const double> head) {
  evaluate(head);
  std::vector<double> rate(flow_.inflow().begin(), flow_.inflow().begin() + flow_.space().dof_count);
  for (std::size_t h = 0; h < released_.size(); ++h) {
    const HeldDof& held = boundary_.held()[h];
    double& row = rate[held.dof];
    row += held.rain - held.demand;
    double kept = row;  // what stays in the soil
    if (held.kind == HeldDof::Kind::head) {
      kept = flow_.volume()[held.dof] * flow_.capacity()[held.dof] * held.head_rate;
    } else {
      mode_[h] = mode_of_rates(h, head[held.dof], row);
      if (is_held(h)) kept = 0;
      if (mode_[h] == Mode::dry_free) kept = row + held.demand;
    }
    released_[h] = row - kept;
    row = kept;
  }
  for (std::size_t i = 0; i < rate.size(); ++i) rate[i] /= flow_.volume()[i];
  return rate;
}

void StageKernel::ledger_rates(std::span<double> rates) const {
  std::fill(rates.begin(), rates.end(), 0.0);
  const std::size_t held_count = released_.size(), conditions = boundary_.condition_count();
  for (std::size_t h = 0; h < held_count; ++h) {
    const HeldDof& held = boundary_.held()[h];
    double released = released_[h];
    if (held.kind == HeldDof::Kind::rain) {
      if (released < 0) {
        rates[held_count + conditions + h] = -released;
        continue;
      }
      // Of what a rain side releases, the rain it was offered runs off; the rest seeps out of the soil.
      rates[h] = std::min(released, held.rain);
      released -= rates[h];
    }
    rates[held_count + held.condition] += released;
  }
  for (std::size_t c = 0; c < conditions; ++c) rates[held_count + c] += flow_.drained()[c];
  if (flow_.has_source()) rates.back() = flow_.source_total();
}

}  // namespace wetfront::fem_reference
