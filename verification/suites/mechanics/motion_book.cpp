#include "verification/suites/mechanics/motion_book.h"

#include <fmt/format.h>

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
  runs_.rows.push_back({label, fmt::format("{}", points), fmt::format("{}", history.mesh.node_count()),
                        fmt::format("{:g}", steps), fmt::format("{:.3f}", history.cpu_seconds),
                        fmt::format("{:.1f}", history.cpu_seconds > 0 ? 1e-6 * work / history.cpu_seconds : 0),
                        fmt::format("{:g}", counter(history, "points held at the mesh border"))});
}

template <int dim>
Motion<dim> MotionBook::move(const std::string& label, const mpm::Problem<dim>& problem,
                             const std::function<bool(const Cloud<dim>&)>& enough) {
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
