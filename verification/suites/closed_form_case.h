#pragma once

#include "fem_reference/richards_problem.h"
#include "reports/record.h"

#include <functional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The reference against a closed form on a ladder of meshes.
struct ClosedFormCase {
  std::string name, title, requirement;
  std::string source;  ///< paper and equations
  /// The problem on `cells` cells per direction; the initial state is the exact one.
  std::function<fem_reference::RichardsProblem(int cells)> problem;
  /// Exact pressure head [m] at a place and a time since the start of the problem [s].
  std::function<double(const meshes::Point&, double)> head;
  std::vector<int> ladder;  ///< cells, each twice the one before
  struct Gate {
    double relative_l2;  ///< of the head over the nodes, on `cells`, at every output time from `from` [s] on
    int cells;
    double from = 0;
    std::string reason;
  } gate;
  double lowest_order = 1.9, highest_order = 2.1;  ///< of the worst error, between the two finest meshes
  std::string order_reason;
};

/// Solves the case on its ladder, judges errors, observed order and water balance, and draws error over cells and
/// profiles over the closed form.
reports::Record run_closed_form(const ClosedFormCase& test);

}  // namespace wetfront::verification
