#pragma once

#include "fem_reference/space/discretisation.h"

#include <memory>
#include <vector>

namespace wetfront::fem_reference {

/// The mesh as it is refined: owns deal.II's triangulation and yields the flat arrays of the moment.
class Space {
 public:
  /// On the problem's own mesh. `shared`: on all ranks at once, p4est dividing the cells among them (two and three
  /// dimensions; adapt() is not for these). Throws std::invalid_argument as discretise().
  explicit Space(const RichardsProblem& problem, bool shared = false);
  ~Space();
  Space(const Space&) = delete;
  Space& operator=(const Space&) = delete;

  Discretisation discretisation() const;

  enum class Mark : signed char { join = -1, keep = 0, halve = 1 };
  /// Halves and joins cells; `marks` per cell of the last discretisation(). Cells are joined where all siblings say so
  /// and the neighbours allow it; more are halved where cells that touch would differ by two halvings. False when
  /// nothing changed.
  bool adapt(const std::vector<Mark>& marks);

  /// What deal.II's side of it does, for one dimension (space.cpp).
  class Triangulated;

 private:
  std::unique_ptr<Triangulated> triangulated_;
};

}  // namespace wetfront::fem_reference
