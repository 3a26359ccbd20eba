#pragma once

#include <string>

namespace wetfront::reports {

/// A part of the plane [m].
struct Extent {
  double left = 0, right = 1, bottom = 0, top = 1;
  void include(double x, double y);
  /// Nothing yet: the first place included makes it.
  static Extent nothing();
};

/// Maps a part of the plane [m] at equal scales into a drawing `width` wide, in whole units of a tenth of a pixel; with
/// ticks along the left and the lower edge.
class PlaneDrawing {
 public:
  PlaneDrawing(const Extent& extent, double width);

  long x(double metres) const;
  long y(double metres) const;
  /// x(m) = x0 + scale m and y(m) = y0 - scale m, for who draws beside.
  double x0() const;
  double y0() const;
  double scale() const { return scale_; }
  double width() const { return width_; }
  double height() const;
  /// The opening tag; `label` for who cannot see it.
  std::string open(const std::string& label) const;
  /// Edges, ticks and their numbers.
  std::string frame() const;

 private:
  Extent extent_;
  double width_, scale_ = 1;
};

}  // namespace wetfront::reports
