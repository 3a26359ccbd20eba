#pragma once

#include "mpm/problem.h"

namespace wetfront::verification {

/// Makes a rigid scene of the matrix one whose skeleton deforms: elastic soil on rollers, in equilibrium at the start.
/// So stiff that its pores stay what they were to a thousandth (the yardsticks know a rigid skeleton), but no stiffer:
/// E is a thousand times the largest stress that suction or pressure puts on the grains, 100 MPa at least.
void give_skeleton(mpm::Problem<2>& problem);

}  // namespace wetfront::verification
