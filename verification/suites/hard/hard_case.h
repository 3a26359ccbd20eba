#pragma once

#include "mpm/problem.h"
#include "verification/suites/case.h"
#include "verification/suites/case_book.h"

#include <functional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The columns of the matrix.
enum class HardScheme { bdf2, backward_euler, semi_implicit, implicit_drag, explicit_drag };
constexpr HardScheme hard_schemes[] = {HardScheme::bdf2, HardScheme::backward_euler, HardScheme::semi_implicit,
                                       HardScheme::implicit_drag, HardScheme::explicit_drag};
/// "seepage_bdf2", ...: the key of a column, also in the index of cases.
std::string key(HardScheme scheme);
/// Steps are limited by stability: these two may refuse a scene for what it would cost.
inline bool may_be_too_expensive(HardScheme scheme) {
  return scheme == HardScheme::implicit_drag || scheme == HardScheme::explicit_drag;
}

/// One number against its bound.
struct Reading {
  std::string what;
  double error;
  Gate bound;
};

/// One row of the matrix: a scene that breaks solvers, run by every scheme within a budget of CPU time.
struct HardCase {
  std::string name, title, requirement, source;  ///< as Case
  Effort effort = Effort::quick;
  /// The scene with one stage, whose scheme and end the column decides; outputs at all of `ends`, others as wanted.
  std::function<mpm::Problem<2>()> problem;
  /// Ends of the run [s], falling: the schemes that may be too expensive take the first they can afford, all others the
  /// first.
  std::vector<double> ends;
  /// These schemes start from the seepage solution at this time [s], so that their window lies where it matters.
  double seepage_until = 0;
  double budget = 4;  ///< CPU seconds per entry
  /// Against the yardstick, at the end of the run. May be called several times, with different ends.
  std::function<std::vector<Reading>(const mpm::Problem<2>&, const meshes::FieldHistory&)> judge;
  bool invalid = false;       ///< the scene makes no sense: every scheme has to refuse it
  bool undetermined = false;  ///< nor does it have one solution: a scheme may refuse it
};

/// The case's page: one finding per entry and bound, the quantity being the scheme; a table of all entries.
Case as_case(const HardCase& test);

}  // namespace wetfront::verification
