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
  Pace pace;
} current;

constexpr double between_looks = 0.1, between_lines = 30;  // s, on a terminal and elsewhere

bool on_terminal() {
  static const bool yes = isatty(STDERR_FILENO) == 1;
  return yes;
}

double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

}  // namespace

double Pace::left(const std::string& stage, double time, double end, double wall) {
  if (stage != stage_ || from_wall_ < 0 || time < from_time_) {
    stage_ = stage;
    from_time_ = time;
    from_wall_ = wall;
  }
  return time > from_time_ ? (wall - from_wall_) * (end - time) / (time - from_time_) : -1;
}

ProgressLine::ProgressLine(const std::string& what) {
  current = {what, Clock::now(), on_terminal() ? Clock::time_point{} : Clock::now(), {}};
}

ProgressLine::~ProgressLine() {
  if (on_terminal()) fmt::print(stderr, "\r\033[K");
}

void show_progress(double time, double end, const char* what) {
  const double left = current.pace.left(what, time, end, seconds_since(current.start));
  if (seconds_since(current.last) < (on_terminal() ? between_looks : between_lines)) return;
  current.last = Clock::now();
  std::string line = current.what;
  if (end > 0) line += fmt::format("  {}: {:.5g} of {:.5g} s ({:.0f} %)", what, time, end, 100 * time / end);
  if (left >= 0) line += fmt::format(", at most about {:.0f} s left", left);
  if (on_terminal())
    fmt::print(stderr, "\r\033[K{}", line);
  else
    fmt::print(stderr, "{}\n", line);
  std::fflush(stderr);
}

}  // namespace wetfront::verification
