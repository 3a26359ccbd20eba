#include "verification/run/run_candidate.h"

#include "verification/run/progress.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace wetfront::verification {
namespace {

std::atomic<bool> asked_to_stop = false;

void ask_to_stop(int) {
  asked_to_stop = true;
}

/// While it lives, SIGINT and SIGTERM are requests.
class StopSignals {
 public:
  StopSignals() : interrupt_(std::signal(SIGINT, ask_to_stop)), terminate_(std::signal(SIGTERM, ask_to_stop)) {}
  ~StopSignals() {
    std::signal(SIGINT, interrupt_);
    std::signal(SIGTERM, terminate_);
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

 private:
  void (*interrupt_)(int);
  void (*terminate_)(int);
};

using WallClock = std::chrono::steady_clock;

mpm::Simulation<2> begin(const mpm::Problem<2>& problem, const Stopping& stopping) {
  if (!stopping.resume) return mpm::Simulation<2>(problem);
  std::string note;
  const auto state = read_checkpoint(stopping.checkpoint, note);
  if (!state && !note.empty())
    throw std::invalid_argument("--resume: " + note +
                                "nothing to go on from (a run anew would overwrite what is there). Run without "
                                "--resume, or into another folder");
  if (!note.empty()) fmt::print(stderr, "resume: {}\n", note);
  if (!state) {
    fmt::print(stderr, "resume: there is no checkpoint to go on from, the run begins anew\n");
    return mpm::Simulation<2>(problem);
  }
  fmt::print(stderr, "resume: from t = {:.6g} s\n", state->time);
  return mpm::Simulation<2>(problem, *state);
}

}  // namespace

Solved run_candidate(const mpm::Problem<2>& problem, const Stopping& stopping) {
  const ProgressLine line("MPM");
  const bool keeps = !stopping.checkpoint.file.empty();
  std::unique_ptr<mpm::Simulation<2>> simulation;
  try {
    simulation = std::make_unique<mpm::Simulation<2>>(begin(problem, stopping));
    const StopSignals signals;
    auto kept = WallClock::now();
    for (long steps = 0; !simulation->finished(); ++steps) {
      simulation->step();
      if (steps % 16 == 0) {
        const auto& stages = simulation->body().stages;
        show_progress(simulation->time(), simulation->stage_end(), stages.empty() ? "mpm" : stages.back().name.c_str());
      }
      const bool stop = asked_to_stop;
      if (keeps && (stop || std::chrono::duration<double>(WallClock::now() - kept).count() >= stopping.every)) {
        write_checkpoint(simulation->state(), stopping.checkpoint);
        kept = WallClock::now();
      }
      if (stop) break;
    }
    Solved solved{simulation->take_history(), "", "", simulation->body(), asked_to_stop.exchange(false)};
    if (solved.stopped)
      solved.gave_up = fmt::format("stopped at t = {:.6g} s as asked{}", simulation->time(),
                                   keeps ? "; --resume goes on from there" : "");
    return solved;
  } catch (const mpm::GaveUp& error) {
    return {error.partial, error.what(), "", simulation ? simulation->body() : mpm::BodyRecord{}};
  }
}

}  // namespace wetfront::verification
