#pragma once

#include <array>
#include <vector>

namespace wetfront::verification {

/// Values at places. Between them the nearest place counts, or (`bilinear`, on a grid in x and y) the value changes
/// linearly along x and y; beyond a grid the value at its edge holds.
struct PlaceTable {
  std::vector<std::array<double, 3>> place;  ///< m
  std::vector<double> value;
  bool bilinear = false;

  double at(const std::array<double, 3>& point) const;
};

/// Whether the places are every pair of some x and some y, in any order, each once; a single x or y counts too.
bool forms_grid(const std::vector<std::array<double, 3>>& places);

/// `values` over `positions` (not falling): linear between them, constant beyond; a position given twice is a jump, at
/// which the later value counts.
double interpolate(const std::vector<double>& positions, const std::vector<double>& values, double at);

}  // namespace wetfront::verification
