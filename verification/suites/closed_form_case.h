#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/suites/case.h"
#include "verification/suites/case_book.h"

#include <functional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The commonest kind of case: the reference against a closed form on a ladder of meshes.
struct ClosedFormCase {
  std::string name, title, requirement, source;  ///< as Case
  Effort effort = Effort::quick;
  /// The problem on `cells` cells per direction; the initial state is the exact one.
  std::function<fem_reference::RichardsProblem(int cells)> problem;
  /// Exact pressure head [m] at a place and a time since the start of the problem [s].
  std::function<double(const meshes::Point&, double)> head;
  std::vector<int> ladder;  ///< cells, each twice the one before
  struct Judged {
    double relative_l2;  ///< of the head over the nodes, on `cells`, at every output time
    int cells;
    std::string reason;
  } gate;
  OrderGate order;  ///< of the error at the worst time, between the two finest meshes
};

/// Solves the ladder, judges errors at the mesh nodes and the observed order, draws error over cells and profiles over
/// the closed form.
Case as_case(const ClosedFormCase& test);

/// Relative L2 over the mesh nodes of the heads of one snapshot, the nodes weighted equally.
double relative_l2(const std::vector<double>& heads, const std::vector<double>& exact);

/// The heads [m] of a snapshot.
std::vector<double> heads_of(const meshes::Snapshot& snapshot, double unit_weight = 9810);

}  // namespace wetfront::verification
