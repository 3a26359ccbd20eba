#include "verification/run/progress.h"

#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace wetfront::verification {
namespace {

using Clock = std::chrono::steady_clock;

// Solvers call a plain function, so what is being shown is kept here: one line on one terminal.
struct {
  std::string what;
  Clock::time_point start, last;
} current;

bool on_terminal() {
  static const bool yes = isatty(STDERR_FILENO) == 1;
  return yes;
}

double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

}  // namespace

ProgressLine::ProgressLine(const std::string& what) {
  current = {what, Clock::now(), {}};
  show_progress(0, 0, "");
}

ProgressLine::~ProgressLine() {
  if (on_terminal()) fmt::print(stderr, "\r\033[K");
}

void show_progress(double time, double end, const char* what) {
  if (!on_terminal() || seconds_since(current.last) < 0.1) return;
  current.last = Clock::now();
  std::string line = current.what;
  if (end > 0 && time > 0) {
    const double left = seconds_since(current.start) * (end - time) / time;
    line += fmt::format("  {:.5g} of {:.5g} s ({:.0f} %)  about {:.0f} s left  {}", time, end, 100 * time / end, left,
                        what);
  }
  fmt::print(stderr, "\r\033[K{}", line);
  std::fflush(stderr);
}

}  // namespace wetfront::verification
