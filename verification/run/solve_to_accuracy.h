#pragma once

#include "verification/run/solve_reference.h"

#include "mpm/problem.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// One run on the way to an accuracy.
struct AccuracyTry {
  std::string resolution;  ///< "cells x 2, tolerance 1e-5"
  double change = 0;       ///< largest relative L2 change of pressure against the run before, over the comparison times
  double cpu_seconds = 0;
};

/// The candidate, refined until its own estimated error is within what was asked for.
struct AccurateCandidate {
  mpm::Problem<2> problem;
  Solved solved;
  std::vector<AccuracyTry> tries;
  double accuracy = 0;   ///< asked for
  double estimate = 0;   ///< of the error of `solved`, same norm as pressure_l2
  bool reached = false;  ///< estimate <= accuracy
  std::string summary;   ///< one sentence
};

/// Halves the cells until doing so changes pressure by no more than `accuracy` (an error that shrinks with the cell, at
/// first order or better, is then no larger), then divides the tolerance of the time integration by ten until that
/// changes it by no more than a quarter of that. Where the change is below half of `accuracy` already the coarser run
/// is good enough and is the one returned. Knows nothing of the reference. Throws SceneError for a mesh of the user's
/// own, whose cells cannot be halved by the scene.
AccurateCandidate solve_to_accuracy(const Scene& scene, const Timeline& timeline, double accuracy);

}  // namespace wetfront::verification
