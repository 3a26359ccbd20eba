#include "mpm/plan/kernel.h"

#include <ctime>

namespace wetfront::mpm {

namespace {
// Reading the thread's CPU clock is a system call of about 0.3 us, as much as a small explicit kernel itself: the first
// calls are timed one by one, then one in `sampling`.
constexpr long always_timed = 128;
constexpr long sampling = 32;

// Kernels may run kernels. While a timed one runs, those inside are timed too, and their time is not its own.
thread_local int timed_depth = 0;
thread_local double inner_seconds = 0;
}  // namespace

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void Kernel::run() {
  const long call = calls_++;
  if (call >= always_timed && call % sampling != 0 && timed_depth == 0) return body_();
  struct Timing {  // ends the timing also when the kernel throws
    Kernel& kernel;
    double outer = inner_seconds, start = thread_cpu_seconds();
    explicit Timing(Kernel& k) : kernel(k) {
      inner_seconds = 0;
      ++timed_depth;
    }
    ~Timing() {
      const double spent = thread_cpu_seconds() - start;
      kernel.timed_seconds_ += spent - inner_seconds;
      ++kernel.timed_calls_;
      inner_seconds = outer + spent;
      --timed_depth;
    }
  } timing(*this);
  body_();
}

double Kernel::cpu_seconds() const {
  return timed_calls_ == 0 ? 0 : timed_seconds_ * static_cast<double>(calls_) / static_cast<double>(timed_calls_);
}

}  // namespace wetfront::mpm
