// The page of one row: every scheme's entry, judged.
#include "verification/suites/hard/hard_entry.h"
#include "verification/suites/problem_setup.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace wetfront::verification {
namespace {

using Outcome = HardEntry::Outcome;

/// Nodal balance of every entry: what the issue asks of every case.
const Gate balance_gate{1e-6, "1", "what is stored is what came in: every scheme is conservative, at any step"};
/// Beyond the maximum principle: in steady ponding 1 Pa is asked; a Newton tolerance and a film leave less than this.
const Gate overshoot_gate{1, "Pa", "heads stay between those of the start and the boundaries (maximum principle)"};
/// Water that stops presses: at most rho c K_s / n = 310 Pa in the seed's sand (Joukowsky), if no drag took its
/// momentum before. A hundredth of it, set when 2.7 Pa had been measured (one cell of soil, full at once).
const Gate inertia_gate{3.1, "Pa", "a hundredth of what the momentum of water at K_s could press with (Joukowsky)"};
const Gate& overshoot_gate_of(HardScheme scheme) {
  return scheme == HardScheme::bdf2 || scheme == HardScheme::backward_euler ? overshoot_gate : inertia_gate;
}
/// Points carry what the pressure at their place holds, cells what the mean of their nodes does: they differ by the
/// curvature over a cell, once, when a full cell takes the nodes' pressure (mpm/two_velocity/README.md section 4).
const Gate hand_over_gate{1e-4, "1", "the curvature of the content over a cell; nothing else may be made or lost"};
const Gate energy_gate{1e-2, "1",
                       "Darcy's flow only loses free energy; time integration of second order leaves this much"};

bool refusal_is_fair(const HardCase& test, const HardEntry& entry) {
  if (test.invalid) return !entry.too_expensive;
  if (entry.too_expensive) return may_be_too_expensive(entry.scheme);
  if (test.undetermined) return true;
  return entry.scheme != HardScheme::bdf2 && entry.scheme != HardScheme::backward_euler &&
         entry.scheme != HardScheme::quasi_static;
}

void fail(CaseBook& book, const HardEntry& entry, const std::string& why) {
  book.judge(key(entry.scheme), key(entry.scheme) + ": " + why + ": " + entry.said, 1,
             {0, "failures", "no entry may stop, hang or refuse without need"});
}

void judge(CaseBook& book, const HardCase& test, const HardEntry& entry) {
  const std::string quantity = key(entry.scheme);
  if (entry.outcome == Outcome::failed) return fail(book, entry, "stopped");
  if (entry.outcome == Outcome::refused) {
    if (!refusal_is_fair(test, entry)) return fail(book, entry, "refused");
    if (test.invalid)
      return book.judge(quantity, quantity + ": refused, as it has to be: " + entry.said, 0,
                        {0, "failures", "a scene that makes no sense is told so before it starts"});
    return book.show(quantity, quantity + ": refused: " + entry.said, entry.estimate, "s");
  }
  if (test.invalid) return fail(book, entry, "ran a scene that makes no sense");
  for (const Reading& reading : entry.readings)
    book.judge(quantity, fmt::format("{}: {} after {:.6g} s", quantity, reading.what, entry.end), reading.error,
               reading.bound);
  book.judge(quantity, quantity + ": water balance of the unknowns", entry.balance, balance_gate);
  if (entry.handed_over > 0)
    book.judge(quantity, quantity + ": water made or lost by the hand-over", entry.handed_over, hand_over_gate);
  book.judge(quantity, quantity + ": pressure beyond what heads can cause", entry.overshoot,
             overshoot_gate_of(entry.scheme));
  if (!std::isnan(entry.energy_growth))
    book.judge(quantity, quantity + ": free energy gained", entry.energy_growth, energy_gate);
  book.show(quantity, quantity + ": water balance by sums over points", entry.particle_balance, "1");
}

/// "stable", "FAIL", "refused".
std::string word(const HardCase& test, const HardEntry& entry) {
  if (entry.outcome == Outcome::refused) return refusal_is_fair(test, entry) ? "refused" : "FAIL (refused)";
  if (entry.outcome == Outcome::failed) return "FAIL (stopped)";
  if (test.invalid) return "FAIL (ran)";
  bool sound = entry.balance <= balance_gate.tolerance && entry.handed_over <= hand_over_gate.tolerance &&
               entry.overshoot <= overshoot_gate_of(entry.scheme).tolerance &&
               !(entry.energy_growth > energy_gate.tolerance);
  for (const Reading& reading : entry.readings) sound = sound && reading.error <= reading.bound.tolerance;
  return sound ? "stable, within bound" : "FAIL (bound)";
}

std::vector<std::string> row(const HardCase& test, const HardEntry& entry) {
  const std::string verdict = word(test, entry);
  if (entry.steps == 0) {
    const std::string cost = entry.too_expensive ? fmt::format("{:.2g} expected", entry.estimate) : "-";
    return {key(entry.scheme), verdict, "-", "-", "-", "-", "-", "-", "-", cost, entry.said};
  }
  std::string error;
  for (const Reading& reading : entry.readings)
    error += fmt::format("{}{:.2g} / {:.2g} {}", error.empty() ? "" : "; ", reading.error, reading.bound.tolerance,
                         reading.bound.unit == "1" ? "" : reading.bound.unit);
  return {key(entry.scheme),
          verdict,
          error,
          fmt::format("{:.3g}", entry.end),
          fmt::format("{:.1e} ({:.1e})", entry.balance, entry.particle_balance),
          fmt::format("{:.2g}", entry.overshoot),
          std::isnan(entry.energy_growth) ? "-" : fmt::format("{:.1e}", entry.energy_growth),
          fmt::format("{:g}, {:g}", entry.newton_failures, entry.rejected),
          fmt::format("{:g}", entry.steps),
          fmt::format("{:.3f} / {:g}", entry.cpu, test.budget),
          entry.said};
}

reports::Table entries_table(const char* title) {
  return {
      title,
      "Verdicts",
      "One row per scheme. Water balance relative to the water moved: by the unknowns (by sums over points). Energy: "
      "free energy gained, over that converted; '-' where free drainage takes an unknown amount, or the skeleton "
      "has a part in it.",
      {"scheme", "verdict", "error / bound", "end [s]", "water balance", "overshoot [Pa]", "energy gain",
       "Newton failures, rejected steps", "steps", "CPU [s] / budget", "said"},
      {}};
}

}  // namespace

Case as_case(const HardCase& test) {
  const auto run = [test](CaseBook& book) {
    if (!test.invalid) book.describe(problem_setup(test.problem()));
    const auto run_all = [&](const char* title, std::span<const HardScheme> schemes) {
      reports::Table table = entries_table(title);
      for (const HardScheme scheme : schemes) {
        if (test.carried && !in_true_time(scheme)) continue;
        if (in_true_time(scheme) && test.windows.empty()) continue;
        const HardEntry entry = run_entry(test, scheme);
        judge(book, test, entry);
        table.rows.push_back(row(test, entry));
        book.spend(entry.cpu);
      }
      book.tabulate(table);
    };
    if (!test.carried) run_all(rigid_entries, rigid_schemes);
    run_all(deforming_entries, deforming_schemes);
  };
  return {test.name, test.title, test.requirement, test.source, test.effort, run};
}

}  // namespace wetfront::verification
