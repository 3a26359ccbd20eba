#include "mpm/two_velocity/content_table.h"

#include <cmath>

namespace wetfront::mpm {

SuctionTable::SuctionTable(const TabulatedCurve& curve) {
  // Suction and its slope at the ends of a piece; `sign` is dSe/dx.
  const auto fill = [&curve](std::vector<Piece>& pieces, double from, double sign) {
    const auto sample = [&](double x) {
      const double s = curve.suction_at(from + sign * x);
      return ValueAndSlope{s, sign / curve.effective_at(s).slope};
    };
    const std::size_t count = std::size_t(octaves) << bits;
    pieces.resize(count);
    ValueAndSlope left = sample(left_end(0));
    for (std::size_t k = 0; k < count; ++k) {
      const double width = left_end(k + 1) - left_end(k);
      const ValueAndSlope right = sample(left_end(k + 1));
      const double rise = (right.value - left.value) / width;
      Piece& piece = pieces[k];
      piece.c[0] = left.value;
      piece.c[1] = std::isfinite(left.slope) && std::isfinite(right.slope) ? left.slope : rise;
      piece.c[2] = std::isfinite(left.slope) && std::isfinite(right.slope)
                       ? (3 * rise - 2 * left.slope - right.slope) / width
                       : 0;
      piece.c[3] = std::isfinite(left.slope) && std::isfinite(right.slope)
                       ? (left.slope + right.slope - 2 * rise) / (width * width)
                       : 0;
      left = right;
    }
  };
  fill(wet_, 1, -1);
  fill(dry_, 0, 1);
}

}  // namespace wetfront::mpm
