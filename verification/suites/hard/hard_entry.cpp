#include "verification/suites/hard/hard_entry.h"

#include "mpm/plan.h"
#include "mpm/simulation.h"
#include "verification/suites/cpu_time.h"
#include "verification/suites/hard/free_energy.h"

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
      return mpm::LiquidScheme::seepage;
    case HardScheme::semi_implicit:
      return mpm::LiquidScheme::semi_implicit;
    case HardScheme::implicit_drag:
      return mpm::LiquidScheme::implicit_drag;
    case HardScheme::explicit_drag:
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

void weigh_water(HardEntry& entry) {
  const auto& ledger = entry.history.ledger;
  const auto& first = ledger.front();
  for (const auto& row : ledger) {
    const double came = row.infiltrated - first.infiltrated - row.outflow + first.outflow;
    const double error = std::abs(row.stored - first.stored - came);
    entry.balance = error <= entry.balance ? entry.balance : error;  // keeps what is not a number
  }
  const auto& last = ledger.back();
  entry.particle_balance = std::abs(last.stored_points - first.stored_points -
                                    (last.infiltrated - first.infiltrated - last.outflow + first.outflow));
  entry.balance /= moved(entry.history);
  entry.particle_balance /= moved(entry.history);
}

void read(const HardCase& test, const mpm::Problem<2>& problem, HardEntry& entry) {
  const meshes::FieldHistory& history = entry.history;
  entry.cpu = history.cpu_seconds;
  entry.steps = counter(history, "steps");
  entry.newton_failures = counter(history, "failed Newton solves");
  entry.rejected = counter(history, "rejected steps");
  entry.overshoot = counter(history, "pressure beyond heads [Pa]");
  if (history.ledger.empty()) return;
  weigh_water(entry);
  entry.energy_growth = free_energy_growth(problem, history);
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

/// Estimates are good to a factor of four: what is planned for a quarter of the budget ends within it.
void check_plan(mpm::Problem<2> problem) {
  problem.cpu_budget /= 4;
  mpm::plan(problem);
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
  }
  return {};
}

mpm::Problem<2> entry_problem(const HardCase& test, HardScheme scheme, double end) {
  mpm::Problem<2> problem = test.problem();
  mpm::Stage& stage = problem.stages.front();
  stage.end_time = end;
  stage.integrator =
      scheme == HardScheme::backward_euler ? mpm::TimeIntegrator::backward_euler : mpm::TimeIntegrator::bdf2;
  stage.liquid = scheme_of(scheme);
  if (may_be_too_expensive(scheme) && test.seepage_until > 0 && end > test.seepage_until) {
    problem.stages.push_back(stage);
    problem.stages.front().name = "before";
    problem.stages.front().liquid = mpm::LiquidScheme::seepage;
    problem.stages.front().end_time = test.seepage_until;
  }
  std::erase_if(problem.output_times, [end](double time) { return time > end; });
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
  for (const double end : test.ends) {
    const mpm::Problem<2> problem = entry_problem(test, scheme, end);
    entry.end = end;
    entry.too_expensive = false;
    try {
      check_plan(problem);
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
