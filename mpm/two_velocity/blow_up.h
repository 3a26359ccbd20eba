#pragma once

#include "mpm/two_velocity/water.h"

#include <string>

namespace wetfront::mpm {

/// Finds a scheme that blows up before its numbers leave all bounds.
///
/// Past its step limit an eigenvalue of the step leaves the unit circle through -1: the mode that decides changes sign
/// at every step and grows. A flow that is followed does neither for long. So: the change of Darcy's flux at a node
/// opposes the one of the step before, several times on end, and is `growth` times the largest change that there was
/// anywhere when this began. (Held against the node's own first change, beats of stable modes would look the same.)
/// (Contents that no pressure explains are caught as well, balance.cpp: growth from rest to there takes a few steps.)
template <int dim>
class BlowUp {
 public:
  /// Of a streak [steps]. Where the pores fill, a blow-up is spent after four steps and leaves noise; but the velocity
  /// of an elastic skeleton may well swing as fast for a while.
  static constexpr int shortest_at_rest = 3, shortest_in_motion = 8;
  static constexpr double growth = 10;

  BlowUp(StagePlan<dim>& plan, const TwoVelocityWater<dim>& water);
  /// Before and after the nodal flux of a step is found. `examine` throws StepFailed.
  void remember();
  void examine();

 private:
  template <class Number>
  auto look_at(std::size_t node);
  /// What, where, how much, and the step against its limit.
  std::string report(std::size_t node, double size) const;

  const StagePlan<dim>& plan_;
  const TwoVelocityWater<dim>& water_;
  Column &before_, &change_, &streak_;
  int shortest_;
  double floor_;  ///< changes whose square is below it are round-off [m2/s2]
};

/// "; dt = ... s is ... times the step limit of ... s. Use a smaller step_safety (now ...)".
template <int dim>
std::string step_against_limit(const StagePlan<dim>& plan, const TwoVelocityWater<dim>& water);
/// "(x, y) m" of a place.
template <int dim>
std::string place_text(const Vector<dim>& x);

}  // namespace wetfront::mpm
