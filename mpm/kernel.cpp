#include "mpm/kernel.h"

#include <ctime>

namespace wetfront::mpm {

namespace {
// Reading the thread's CPU clock is a system call of about 0.3 us, as much as a small explicit kernel itself. The
// first calls are timed one by one (warm-up differs), then one in `sampling`.
constexpr long always_timed = 128;
constexpr long sampling = 32;
}  // namespace

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void Kernel::run() {
  const long call = calls_++;
  if (call >= always_timed && call % sampling != 0) return body_();
  const double start = thread_cpu_seconds();
  body_();
  const double spent = thread_cpu_seconds() - start;
  if (call < always_timed) {
    first_seconds_ += spent;
  } else {
    sampled_seconds_ += spent;
    ++timed_calls_;
  }
}

double Kernel::cpu_seconds() const {
  if (timed_calls_ == 0) return first_seconds_;
  return first_seconds_ +
         sampled_seconds_ * static_cast<double>(calls_ - always_timed) / static_cast<double>(timed_calls_);
}

}  // namespace wetfront::mpm
