#pragma once

#include <ctime>

namespace wetfront::fem_reference {

/// CPU seconds of the calling thread.
inline double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Cost {
  double seconds = 0;
  long calls = 0;
};

/// Adds its own life time to a cost.
class CostTimer {
 public:
  explicit CostTimer(Cost& cost) : cost_(cost), start_(cpu_now()) {}
  ~CostTimer() {
    cost_.seconds += cpu_now() - start_;
    ++cost_.calls;
  }
  CostTimer(const CostTimer&) = delete;
  CostTimer& operator=(const CostTimer&) = delete;

 private:
  Cost& cost_;
  double start_;
};

}  // namespace wetfront::fem_reference
