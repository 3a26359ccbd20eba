#pragma once

#include "mpm/problem.h"
#include "verification/suites/mechanics/motion_book.h"

#include <functional>
#include <memory>

namespace wetfront::verification {

/// A motion that is known, as a problem on so many cells per direction and the error of a run of it.
struct ManufacturedMotion {
  std::function<mpm::Problem<2>(int cells, const mpm::SkeletonScheme&)> problem;
  std::function<double(const Motion<2>&)> error;  ///< rms of the displacement, relative, at the worst output time
  double scale = 1;                               ///< what errors are relative to [m]
};

/// rms of the distance between the same points of two runs on one mesh, at the worst output time [m].
double apart(const Motion<2>& one, const Motion<2>& other);

/// Amplitude A [m] in a unit square, E = 10 kPa, nu = 0.3, rho = 1000 kg/m3, over one period 2/c.
ManufacturedMotion axis_aligned_motion(double amplitude = 0.05);
/// The ring of Kamojjala et al. 2015 in a square of 2.56 m, for 1 s: there and back, by at most `angle` [rad].
ManufacturedMotion vortex_motion(double angle = 1);

}  // namespace wetfront::verification
