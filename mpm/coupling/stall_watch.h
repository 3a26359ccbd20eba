#pragma once

#include <algorithm>
#include <limits>

namespace wetfront::mpm {

/// Tells a relaxation that gets no nearer to equilibrium from one that does: from window to window (three crossings of
/// the body by a wave) neither the least share of forces out of balance falls by a tenth nor the body moves on. Points
/// without stress at a free surface keep a few ten-thousandths of the forces busy for good (README.md section 3).
class StallWatch {
 public:
  void begin(long window, double least_motion) {
    *this = {};
    window_ = window;
    least_motion_ = least_motion;
  }

  /// `moved`: how far the body has gone since the step began [m].
  bool stalled(long iteration, double ratio, double moved) {
    best_ = std::min(best_, ratio);
    if (iteration < ends_) return false;
    const bool stands = best_ > 0.9 * best_before_ && moved - moved_before_ < least_motion_;
    ends_ = iteration + window_;
    best_before_ = std::min(best_before_, best_);
    best_ = std::numeric_limits<double>::infinity();
    moved_before_ = moved;
    return stands;
  }

 private:
  long window_ = 0, ends_ = 0;
  double least_motion_ = 0, moved_before_ = 0;
  double best_ = std::numeric_limits<double>::infinity(), best_before_ = best_;
};

}  // namespace wetfront::mpm
