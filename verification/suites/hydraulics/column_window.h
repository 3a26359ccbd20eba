#pragma once

#include "mpm/problem.h"
#include "verification/suites/case_book.h"
#include "verification/suites/seed_column.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// A stretch of a column's rain in which schemes are compared: every one starts from the reference's state at its
/// beginning and is held against the reference at its end, so that nothing but the window's own water counts.
class ColumnWindow {
 public:
  /// `from`, `to`: shares of the filling time. Solves the reference on 640 cells and enters it into the book.
  ColumnWindow(const SeedColumn& column, double from, double to, CaseBook& book);

  fem_reference::RichardsProblem problem(int cells) const;
  /// The same on material points, moved by one scheme.
  mpm::Problem<2> problem(int cells, mpm::LiquidScheme scheme) const;

  /// Relative L2 of the pressure at the end in the cells, in the scheme's own sense (averages or values at centres).
  double cell_error(const meshes::FieldHistory& history) const;
  /// The same at the nodes.
  double node_error(const meshes::FieldHistory& history) const;
  double seconds() const { return seconds_; }
  /// The reference from the window's beginning: two snapshots, begin and end.
  const meshes::FieldHistory& yardstick() const { return yardstick_; }

 private:
  SeedColumn column_;
  meshes::FieldHistory yardstick_;
  double seconds_;
};

/// Explicit drag takes steps of 2e-7 s at 10 kPa of suction; so a low, moist column of the same sand, where it takes
/// some 1e-5 s: 0.3 m, hydrostatic over its base, 2 s of rain of 1.5e-4 m/s.
fem_reference::RichardsProblem moist_column(int cells);
mpm::Problem<2> moist_column(int cells, mpm::LiquidScheme scheme);

std::string scheme_name(mpm::LiquidScheme scheme);

}  // namespace wetfront::verification
