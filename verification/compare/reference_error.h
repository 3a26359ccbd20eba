#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace wetfront::verification {

/// How the solutions on three meshes, each with cells half as large as the one before, approach each other.
enum class Convergence {
  none,         ///< no meshes were compared
  monotone,     ///< the changes shrink and point the same way
  oscillatory,  ///< they shrink and point back
  divergent,    ///< they do not shrink
  settled,      ///< they are below what the time integration leaves open: the mesh no longer matters
  two_meshes,   ///< there is no coarser mesh: an order cannot be observed
};
const char* word(Convergence convergence);  ///< "" for none

/// What the reference does not know about one of its own quantities, in the unit of the quantity's error.
struct ReferenceError {
  double bound = 0;     ///< spatial + temporal, with their factors of safety
  double spatial = 0;   ///< of the reference's mesh
  double temporal = 0;  ///< of its tolerance
  /// Observed order in the cell size; NaN unless monotone.
  double order = std::numeric_limits<double>::quiet_NaN();
  Convergence convergence = Convergence::none;
};

/// One quantity (a number, or a field read at the same places) from the reference and its relatives.
struct ReferenceValues {
  std::vector<double> reference;               ///< on the scene's mesh
  std::optional<std::vector<double>> coarser;  ///< cells twice as large
  std::vector<double> finer;                   ///< cells half as large
  std::vector<double> tighter;                 ///< a tenth of the tolerance
};

/// Size of a difference, e.g. the norm in which the candidate's error is measured.
using Distance = std::function<double(const std::vector<double>& a, const std::vector<double>& reference)>;

/// Richardson's estimate with the factors of safety of Roache (1998, Verification and Validation in Computational
/// Science and Engineering, sec. 5.9; Eca & Hoekstra 2014, J. Comput. Phys. 262:104): the error of the reference is
/// |finer - reference| / (1 - 2^-order), times 1.25 where the order was observed and lies between 1 and 3 (the elements
/// have 2 or 3), times 3 with the order taken as 0.5 at least and 2 at most elsewhere. Where the changes do not shrink
/// steadily it is 3 times the larger of them. In time it is twice the change that a tenth of the tolerance makes:
/// BDF's error is nearly proportional to its tolerance, but not smoothly.
/// NaN where no solution has the quantity, infinity where only some have it.
ReferenceError reference_error(const ReferenceValues& values, const Distance& distance);

}  // namespace wetfront::verification
