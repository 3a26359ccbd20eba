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

}  // namespace

MotionBook::MotionBook(CaseBook& to) : page(to) {
  runs_ = {"Runs",
           "Cost",
           "One row per run.",
           {"run", "points", "nodes", "steps", "CPU [s]", "million point-steps per CPU-s", "points held at the border"},
           {}};
}

void MotionBook::enter(const std::string& label, const meshes::FieldHistory& history, std::size_t points) {
  const double steps = counter(history, "steps"), work = steps * static_cast<double>(points);
  page.spend(history.cpu_seconds, static_cast<double>(history.mesh.node_count()));
  page.sign(history.mesh);
  balance(history);
  runs_.rows.push_back({label, fmt::format("{}", points), fmt::format("{}", history.mesh.node_count()),
                        fmt::format("{:g}", steps), fmt::format("{:.3f}", history.cpu_seconds),
                        fmt::format("{:.1f}", history.cpu_seconds > 0 ? 1e-6 * work / history.cpu_seconds : 0),
                        fmt::format("{:g}", counter(history, "points held at the mesh border"))});
}

/// Relative to the largest momentum and energy that are or went anywhere in the run.
void MotionBook::balance(const meshes::FieldHistory& history) {
  if (history.motion.empty()) return;
  double momentum = 0, momentum_size = 0, energy = 0, energy_size = 0;
  for (const meshes::MotionRow& row : history.motion) {
    momentum_size = std::max(momentum_size, row.motion);
    for (std::size_t a = 0; a < 3; ++a) {
      momentum = std::max(momentum, std::abs(row.momentum_drift[a]));
      momentum_size = std::max({momentum_size, std::abs(row.momentum[a]), std::abs(row.impulse[a])});
    }
    energy = std::max(energy, std::abs(row.drift));
    energy_size = std::max({energy_size, row.kinetic, std::abs(row.potential - history.motion.front().potential),
                            std::abs(row.stress_work), std::abs(row.load_work)});
  }
  if (momentum_size > 0) momentum_ = std::max(momentum_, momentum / momentum_size);
  if (energy_size > 0) energy_ = std::max(energy_, energy / energy_size);
  ++balanced_;
}

template <int dim>
Motion<dim> MotionBook::move(const std::string& label, const mpm::Problem<dim>& problem,
                             const std::function<bool(const Cloud<dim>&)>& enough) {
  page.describe(problem_setup(problem));
  try {
    Motion<dim> motion = verification::move<dim>(problem, enough);
    enter(label, motion.history, motion.points);
    return motion;
  } catch (const mpm::GaveUp& failure) {
    enter(label + " (gave up)", failure.partial, 0);
    throw;
  }
}

void MotionBook::finish() {
  if (balanced_ > 0) {
    page.judge("momentum", fmt::format("momentum against impulses and reactions, worst of {} runs", balanced_),
               momentum_, {1e-9, "1", "what nodes exchange sums to zero: round-off of up to 1e5 steps"});
    page.show("energy",
              fmt::format("energy against work, worst of {} runs (mapping between points and nodes)", balanced_),
              energy_, "1");
  }
  if (!runs_.rows.empty()) page.tabulate(runs_);
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
