#pragma once

#include "mpm/plan/column.h"
#include "mpm/seepage/soil_content.h"

#include <cstddef>
#include <vector>

namespace wetfront::mpm {

/// How the pressure of the nodes answers to pores that grow or shrink while no water passes between nodes (README.md
/// section 8): P_i is the pore volume at a node [m^dim], of each soil.
class UndrainedAnswer {
 public:
  /// `contents`: of each soil; outlives this.
  explicit UndrainedAnswer(const std::vector<SoilContent>& contents) : contents_(contents) {}

  /// `pore_volume`: a component per soil.
  void begin(const Column& pore_volume);
  /// Pores around a node as they are on the way, of all soils [m^dim].
  double room(std::size_t node) const;
  void grow(int soil, int node, double volume) {
    grown_[static_cast<std::size_t>(soil)][static_cast<std::size_t>(node)] += volume;
  }
  /// Pressures of the nodes [Pa] answer to what their pores have grown by, which is theirs from then on.
  void take(double* pressure);

 private:
  double answered(std::size_t node, double p) const;
  double answered_by_several(std::size_t node, double before, double guess) const;

  const std::vector<SoilContent>& contents_;
  std::vector<std::vector<double>> pores_, grown_;  ///< nodes, per soil
};

}  // namespace wetfront::mpm
