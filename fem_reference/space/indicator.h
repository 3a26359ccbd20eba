#pragma once

#include "fem_reference/soil/soil_law.h"
#include "fem_reference/space/space.h"

#include <span>

namespace wetfront::fem_reference {

/// Where the mesh ought to be finer, by the change of the water content over each cell (README, Eq 7).
class Indicator {
 public:
  explicit Indicator(const RichardsProblem& problem);

  /// Per cell: the largest difference of the water content between its corners [-], hanging ones too.
  std::vector<double> change(const Discretisation& space, const std::vector<SoilLaw>& laws,
                             std::span<const double> head) const;
  /// Some cell that may still be halved shows more than the threshold.
  bool due(const Discretisation& space, const std::vector<SoilLaw>& laws, std::span<const double> head) const;
  /// Most cells could be joined: a front is gone.
  bool mostly_joinable(const Discretisation& space, const std::vector<SoilLaw>& laws,
                       std::span<const double> head) const;
  std::vector<Space::Mark> marks(const Discretisation& space, const std::vector<SoilLaw>& laws,
                                 std::span<const double> head) const;

 private:
  void spread(const Discretisation& space, std::vector<int>& level) const;

  Adaptivity adaptivity_;
};

}  // namespace wetfront::fem_reference
