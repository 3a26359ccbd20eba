#pragma once

#include "mpm/problem.h"
#include "verification/suites/case.h"
#include "verification/suites/case_book.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The columns of the matrix: with a rigid skeleton, and with one that deforms.
enum class HardScheme {
  bdf2,
  backward_euler,
  semi_implicit,
  implicit_drag,
  explicit_drag,
  quasi_static,  ///< seepage, from equilibrium to equilibrium
  true_time,     ///< seepage in a skeleton with inertia, grains and water as one body
  moving_semi_implicit,
  moving_implicit_drag,
  moving_explicit_drag
};
constexpr HardScheme rigid_schemes[] = {HardScheme::bdf2, HardScheme::backward_euler, HardScheme::semi_implicit,
                                        HardScheme::implicit_drag, HardScheme::explicit_drag};
constexpr HardScheme deforming_schemes[] = {HardScheme::quasi_static, HardScheme::true_time,
                                            HardScheme::moving_semi_implicit, HardScheme::moving_implicit_drag,
                                            HardScheme::moving_explicit_drag};
/// "seepage_bdf2", ...: the key of a column, also in the index of cases.
std::string key(HardScheme scheme);
inline bool deforms(HardScheme scheme) {
  return scheme >= HardScheme::quasi_static;
}
/// The skeleton has inertia: such an entry is a window of seconds after seepage.
inline bool in_true_time(HardScheme scheme) {
  return deforms(scheme) && scheme != HardScheme::quasi_static;
}
/// Steps are limited by stability: these may refuse a scene for what it would cost.
inline bool may_be_too_expensive(HardScheme scheme) {
  return in_true_time(scheme) || scheme == HardScheme::implicit_drag || scheme == HardScheme::explicit_drag;
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
  /// Lengths of the window of schemes whose skeleton has inertia [s], falling: they take the first they can afford.
  /// None: the row says nothing about so short a time.
  std::vector<double> windows{0.1, 0.02, 0.005};
  std::optional<double> window_from{};  ///< s; else where the water is under way
  double budget = 4;                    ///< CPU seconds per entry
  /// Against the yardstick, at the end of the run. May be called several times, with different ends.
  std::function<std::vector<Reading>(const mpm::Problem<2>&, const meshes::FieldHistory&)> judge;
  bool invalid = false;       ///< the scene makes no sense: every scheme has to refuse it
  bool undetermined = false;  ///< nor does it have one solution: a scheme may refuse it
  /// The scene has a skeleton of its own that moves as a whole, from the beginning to one of `ends`: for schemes in
  /// true time.
  bool carried = false;

  /// When windows begin [s]: where fronts are under way or the surface ponds.
  double window_begin() const { return window_from.value_or(seepage_until > 0 ? seepage_until : ends.front() / 2); }
};

/// Titles of the tables of entries on a case's page.
inline constexpr const char *rigid_entries = "Entries", *deforming_entries = "Entries with a deforming skeleton";

/// The case's page: one finding per entry and bound, the quantity being the scheme; a table of all entries.
Case as_case(const HardCase& test);

}  // namespace wetfront::verification
