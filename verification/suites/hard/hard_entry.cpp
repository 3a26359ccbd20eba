#include "verification/suites/hard/hard_entry.h"

#include "mpm/plan.h"
#include "mpm/simulation.h"
#include "verification/suites/cpu_time.h"
#include "verification/suites/hard/free_energy.h"
#include "verification/suites/hard/give_skeleton.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wetfront::verification {
namespace {

mpm::LiquidScheme scheme_of(HardScheme scheme) {
  switch (scheme) {
    case HardScheme::bdf2:
    case HardScheme::backward_euler:
    case HardScheme::quasi_static:
    case HardScheme::true_time:
      return mpm::LiquidScheme::seepage;
    case HardScheme::semi_implicit:
    case HardScheme::moving_semi_implicit:
      return mpm::LiquidScheme::semi_implicit;
    case HardScheme::implicit_drag:
    case HardScheme::moving_implicit_drag:
      return mpm::LiquidScheme::implicit_drag;
    case HardScheme::explicit_drag:
    case HardScheme::moving_explicit_drag:
      return mpm::LiquidScheme::explicit_drag;
  }
  return {};
}

double counter(const meshes::FieldHistory& history, const std::string& name) {
  const auto found = history.counters.find(name);
  return found == history.counters.end() ? 0 : found->second;
}

/// Water that went in or out, either way; what is stored where next to none did.
double moved(const meshes::FieldHistory& history) {
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  const double passed = last.infiltrated - first.infiltrated + std::abs(last.outflow - first.outflow);
  return passed > 1e-9 * first.stored ? passed : first.stored;
}

/// `turn`: when the points' water was taken over from another scheme.
void weigh_water(HardEntry& entry, double turn) {
  const auto& ledger = entry.history.ledger;
  const auto& first = ledger.front();
  const double given = counter(entry.history, "hand-over: stored water change");
  const auto came = [&](const meshes::LedgerRow& row) {
    return row.infiltrated - first.infiltrated - row.outflow + first.outflow + (row.time > turn ? given : 0);
  };
  for (const auto& row : ledger) {
    const double error = std::abs(row.stored - first.stored - came(row));
    entry.balance = error <= entry.balance ? entry.balance : error;  // keeps what is not a number
  }
  const auto& last = ledger.back();
  entry.particle_balance = std::abs(last.stored_points - first.stored_points - came(last));
  entry.balance /= moved(entry.history);
  entry.particle_balance /= moved(entry.history);
  entry.handed_over = std::abs(given) / first.stored;
}

void read(const HardCase& test, const mpm::Problem<2>& problem, HardEntry& entry) {
  const meshes::FieldHistory& history = entry.history;
  entry.cpu = history.cpu_seconds;
  entry.steps = counter(history, "steps");
  entry.newton_failures = counter(history, "failed Newton solves");
  entry.rejected = counter(history, "rejected steps");
  entry.overshoot = counter(history, "pressure beyond heads [Pa]");
  if (history.ledger.empty()) return;
  weigh_water(entry, problem.stages.size() > 1 ? problem.stages.front().end_time : 0);
  // The skeleton's share of the energy is not in the sum.
  entry.energy_growth = deforms(entry.scheme) ? std::nan("") : free_energy_growth(problem, history);
  if (entry.outcome == HardEntry::Outcome::ran) entry.readings = test.judge(problem, history);
}

/// Runs step by step, so that the partial history of a failure is kept.
void run(const HardCase& test, const mpm::Problem<2>& problem, HardEntry& entry) {
  try {
    entry.history = mpm::run(problem);
    entry.outcome = HardEntry::Outcome::ran;
  } catch (const mpm::GaveUp& failure) {
    entry.history = failure.partial;
    entry.said = failure.what();
    entry.outcome = HardEntry::Outcome::failed;  // also after a longer window was refused
  }
  read(test, problem, entry);
}

bool names_cost(const std::string& message) {
  return message.find("too expensive: about") != std::string::npos;
}

/// What may be planned of the budget, so that the run ends within it. Estimates are good to a factor of four at rest;
/// of skeletons that move to fifty (explicit drag when rain of 10 K_s fills the next cell), and a window needs no more
/// than that.
void check_plan(mpm::Problem<2> problem, HardScheme scheme) {
  problem.cpu_budget /= scheme == HardScheme::moving_explicit_drag ? 160 : deforms(scheme) ? 8 : 4;
  mpm::plan(problem);
}

/// When entries end: windows of seconds for a skeleton with inertia, else as the row has it.
std::vector<double> ends_of(const HardCase& test, HardScheme scheme) {
  if (!in_true_time(scheme) || test.carried) return test.ends;
  std::vector<double> ends;
  for (const double window : test.windows) ends.push_back(test.window_begin() + window);
  return ends;
}

double estimate_of(mpm::Problem<2> problem) {
  problem.cpu_budget = 0;
  double total = 0;
  for (const auto& stage : mpm::plan(problem)) total += stage.estimated_cpu_seconds;
  return total;
}

}  // namespace

std::string key(HardScheme scheme) {
  switch (scheme) {
    case HardScheme::bdf2:
      return "seepage_bdf2";
    case HardScheme::backward_euler:
      return "seepage_backward_euler";
    case HardScheme::semi_implicit:
      return "semi_implicit";
    case HardScheme::implicit_drag:
      return "implicit_drag";
    case HardScheme::explicit_drag:
      return "explicit";
    case HardScheme::quasi_static:
      return "deforming_quasi_static";
    case HardScheme::true_time:
      return "deforming_true_time";
    case HardScheme::moving_semi_implicit:
      return "deforming_semi_implicit";
    case HardScheme::moving_implicit_drag:
      return "deforming_implicit_drag";
    case HardScheme::moving_explicit_drag:
      return "deforming_explicit";
  }
  return {};
}

mpm::Problem<2> entry_problem(const HardCase& test, HardScheme scheme, double end) {
  mpm::Problem<2> problem = test.problem();
  if (deforms(scheme) && !test.carried) give_skeleton(problem);
  mpm::Stage& stage = problem.stages.front();
  stage.end_time = end;
  stage.integrator =
      scheme == HardScheme::backward_euler ? mpm::TimeIntegrator::backward_euler : mpm::TimeIntegrator::bdf2;
  stage.liquid = scheme_of(scheme);
  stage.motion = in_true_time(scheme) ? mpm::SkeletonMotion::dynamic : mpm::SkeletonMotion::quasi_static;
  const double before = test.carried                   ? 0
                        : in_true_time(scheme)         ? test.window_begin()
                        : may_be_too_expensive(scheme) ? test.seepage_until
                                                       : 0;
  if (before > 0 && end > before) {
    problem.stages.push_back(stage);
    problem.stages.front().name = "before";
    problem.stages.front().liquid = mpm::LiquidScheme::seepage;
    problem.stages.front().motion = mpm::SkeletonMotion::quasi_static;
    problem.stages.front().end_time = before;
  }
  std::erase_if(problem.output_times, [end](double time) { return time > end; });
  if (in_true_time(scheme) && problem.output_times.back() != end) problem.output_times.push_back(end);
  // Without it the end would be judged by an earlier state, the start perhaps.
  if (problem.output_times.empty() || problem.output_times.back() != end)
    throw std::logic_error(fmt::format("the row '{}' may end at {:g} s, but keeps no output there", test.name, end));
  problem.cpu_budget = test.budget;
  return problem;
}

HardEntry run_entry(const HardCase& test, HardScheme scheme) {
  HardEntry entry;
  entry.scheme = scheme;
  const CpuTime clock;
  for (const double end : ends_of(test, scheme)) {
    const mpm::Problem<2> problem = entry_problem(test, scheme, end);
    entry.end = end;
    entry.too_expensive = false;
    try {
      check_plan(problem, scheme);
      run(test, problem, entry);
      return entry;
    } catch (const mpm::CannotPlan& refused) {
      entry.outcome = HardEntry::Outcome::refused;
      entry.said = refused.what();
      entry.too_expensive = names_cost(entry.said);
      if (entry.too_expensive) entry.estimate = estimate_of(problem);
    } catch (const std::exception& failure) {
      entry.outcome = HardEntry::Outcome::failed;
      entry.said = std::string("stopped with ") + failure.what();
    }
    entry.cpu = clock.seconds();
    if (!may_be_too_expensive(scheme) || !entry.too_expensive) return entry;
  }
  return entry;
}

}  // namespace wetfront::verification
