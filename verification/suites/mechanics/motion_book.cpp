#include "verification/suites/mechanics/motion_book.h"

#include "verification/suites/problem_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

double counter(const meshes::FieldHistory& history, const std::string& name) {
  const auto found = history.counters.find(name);
  return found == history.counters.end() ? 0 : found->second;
}

template <int dim>
bool weight_or_contact(const mpm::Problem<dim>& problem) {
  return std::ranges::any_of(problem.gravity, [](double g) { return g != 0; }) ||
         std::ranges::any_of(problem.skeleton_boundary, [](const mpm::SkeletonBoundary& side) {
           return std::holds_alternative<mpm::FrictionalContact>(side);
         });
}

}  // namespace

const Gate MotionBook::round_off_energy{
    1e-9, "1", "FLIP gives points what forces do at nodes: round-off of up to 1e5 steps (measured 3e-14)"};
const Gate MotionBook::made_by_weight{0.02, "1",
                                      "a run that makes energy blows up in the end, so its gate is its own: gravity's "
                                      "work is taken where points are, that "
                                      "of forces at nodes (up to .0071 measured, columns)"};
const Gate MotionBook::made_without{
    1e-3, "1", "without weight and contact nothing but mapping back could make any (a turning block: .0008)"};

MotionBook::MotionBook(CaseBook& to) : page(to) {
  runs_ = {"Runs",
           "Cost",
           "One row per run.",
           {"run", "points", "nodes", "steps", "CPU [s]", "million point-steps per CPU-s", "points held at the border"},
           {}};
  energies_ = {
      "Energy",
      "Balances",
      "One row per run, at its end, over the largest energy that was or went anywhere: released + loads = kinetic "
      "+ stored + rest + resisted + mapping since the dynamic stage began. The rest is plastic; of elastic soil, what "
      "points do not see of the motion of the nodes.",
      {"run", "exchanged [J]", "released by gravity", "work of loads and water", "kinetic", "stored elastically",
       "rest of the work on the soil", "friction on sides, damping", "mapping"},
      {}};
}

void MotionBook::enter(const std::string& label, const meshes::FieldHistory& history, std::size_t points, int threads) {
  const double steps = counter(history, "steps"), work = steps * static_cast<double>(points);
  page.spend(history.cpu_seconds, static_cast<double>(history.mesh.node_count()));
  page.sign(history.mesh, threads);
  balance(history);
  runs_.rows.push_back({label, fmt::format("{}", points), fmt::format("{}", history.mesh.node_count()),
                        fmt::format("{:g}", steps), fmt::format("{:.3f}", history.cpu_seconds),
                        fmt::format("{:.1f}", history.cpu_seconds > 0 ? 1e-6 * work / history.cpu_seconds : 0),
                        fmt::format("{:g}", counter(history, "points held at the mesh border"))});
}

/// Relative to the largest momentum that is or went anywhere in the run.
void MotionBook::balance(const meshes::FieldHistory& history) {
  if (history.motion.empty()) return;
  double momentum = 0, momentum_size = 0;
  for (const meshes::MotionRow& row : history.motion) {
    momentum_size = std::max(momentum_size, row.motion);
    for (std::size_t a = 0; a < 3; ++a) {
      momentum = std::max(momentum, std::abs(row.momentum_drift[a]));
      momentum_size = std::max({momentum_size, std::abs(row.momentum[a]), std::abs(row.impulse[a])});
    }
  }
  if (momentum_size > 0) momentum_ = std::max(momentum_, momentum / momentum_size);
  ++balanced_;
}

/// Shares of what was exchanged. "-": a law whose stored energy its stress does not tell.
void MotionBook::enter_energy(const std::string& label, const EnergySplit& split, const Gate& made) {
  if (!(split.size > 0)) return;
  if (mappings_.empty() || mappings_.back().may_lose.tolerance != energy.tolerance ||
      mappings_.back().may_make.tolerance != made.tolerance)
    mappings_.push_back({energy, made});
  Mapping& mapping = mappings_.back();
  const auto worse = [&](double before, double now) { return now <= before ? before : now; };  // keeps NaN
  mapping.lost = worse(mapping.lost, split.worst_loss / split.size);
  mapping.made = worse(mapping.made, split.worst_gain / split.size);
  ++mapping.runs;
  const auto share = [&](double energy) { return fmt::format("{:.4f}", energy / split.size); };
  energies_.rows.push_back({label, fmt::format("{:.4g}", split.size), share(split.released), share(split.loads),
                            share(split.kinetic), split.stored ? share(*split.stored) : "-",
                            share(split.stress_work - split.stored.value_or(0)), share(split.resisted),
                            share(split.mapping)});
}

template <int dim>
Motion<dim> MotionBook::move(const std::string& label, const mpm::Problem<dim>& problem,
                             const std::function<bool(const Cloud<dim>&)>& enough) {
  page.describe(problem_setup(problem));
  try {
    Motion<dim> motion = verification::move<dim>(problem, enough);
    enter(label, motion.history, motion.points, problem.threads);
    if (!motion.history.motion.empty()) {
      const Gate& usual = weight_or_contact(problem) ? made_by_weight : made_without;
      enter_energy(label, energy_split<dim>(problem, motion),
                   energy_made.value_or(usual.tolerance < energy.tolerance ? usual : energy));
    }
    return motion;
  } catch (const mpm::GaveUp& failure) {
    enter(label + " (gave up)", failure.partial, 0, problem.threads);
    throw;
  }
}

void MotionBook::finish() {
  if (balanced_ > 0) {
    page.judge("momentum", fmt::format("momentum against impulses and reactions, worst of {} runs", balanced_),
               momentum_, {1e-9, "1", "what nodes exchange sums to zero: round-off of up to 1e5 steps"});
    for (const Mapping& mapping : mappings_) {
      const std::string of =
          fmt::format(" by mapping between points and nodes, over what was exchanged, worst of {} runs", mapping.runs);
      page.judge("energy", "energy made" + of, mapping.made, mapping.may_make);
      page.judge("energy", "energy lost" + of, mapping.lost, mapping.may_lose);
    }
  }
  if (!runs_.rows.empty()) page.tabulate(runs_);
  if (!energies_.rows.empty()) page.tabulate(energies_);
}

Case motion_case(Case heading, std::function<void(MotionBook&)> run) {
  heading.run = [run = std::move(run)](CaseBook& page) {
    MotionBook book(page);
    try {
      run(book);
    } catch (...) {
      book.finish();
      throw;
    }
    book.finish();
  };
  return heading;
}

template Motion<2> MotionBook::move(const std::string&, const mpm::Problem<2>&,
                                    const std::function<bool(const Cloud<2>&)>&);
template Motion<3> MotionBook::move(const std::string&, const mpm::Problem<3>&,
                                    const std::function<bool(const Cloud<3>&)>&);

}  // namespace wetfront::verification
