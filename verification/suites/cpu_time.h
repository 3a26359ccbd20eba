#pragma once

#include <ctime>

namespace wetfront::verification {

/// CPU seconds of this process since it was made.
class CpuTime {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace wetfront::verification
