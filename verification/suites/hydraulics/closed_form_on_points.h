#pragma once

#include "mpm/problem.h"
#include "verification/suites/closed_form_case.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// A closed form that judges the reference, judging `seepage` on material points: the same problem, other meshes. Where
/// there is none (`exact.head` empty) the reference itself is the yardstick, on `reference_cells`.
struct OnPoints {
  ClosedFormCase exact;
  std::vector<int> ladder;      ///< cells, each twice the one before; instead of the reference's
  ClosedFormCase::Judged gate;  ///< 4 points per cell
  OrderGate order;              ///< between the two finest meshes
  Effort effort = Effort::everyday;
  std::vector<int> points_per_cell = {1, 9};  ///< tried on the coarsest mesh beside 4
  double change_with_points = 0.05;           ///< allowed share by which the error changes from 4 to 9
  double time_tolerance = 1e-8;               ///< leaves less than a tenth of the error in space
  int reference_cells = 0;
  double reference_tolerance = 1e-7;
};

/// Nodal errors on the ladder, observed order in the cell size, error over points per cell, profiles, cost.
Case as_case(const OnPoints& test);

/// Relative L2 over the nodes of the head, one per snapshot, against `exact` (places as in the problem of the
/// reference: elevation first where that is a line).
std::vector<double> head_errors(const meshes::FieldHistory& history, const ClosedFormCase& exact, bool line);

}  // namespace wetfront::verification
