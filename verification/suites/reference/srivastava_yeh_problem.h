#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/exact/srivastava_yeh.h"

namespace wetfront::verification {

/// The printed layer: 1 m, Ks = 1 cm/h, the flux jumps from 0.1 to 0.9 cm/h (wetting) or back; alpha [1/m].
exact::SrivastavaYeh srivastava_yeh_layer(double alpha, bool wetting);

/// It, started from the closed form, with outputs at the printed times.
fem_reference::RichardsProblem srivastava_yeh_problem(const exact::SrivastavaYeh& layer, int cells);

}  // namespace wetfront::verification
