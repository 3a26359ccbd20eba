#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/exact/manufactured.h"

namespace wetfront::verification {

/// A unit box of `dim` dimensions under gravity along its last axis. The head is uniform at t = 0 (which every element
/// represents exactly, quadratic ones too, though initial heads are given at the mesh nodes only) and then swings in
/// two oblique standing waves, -1.4 to -0.4 m. van Genuchten's soil or an exponential one, T full.
exact::Manufactured manufactured_box(int dim, bool van_genuchten);

/// It on `cells` cells per direction, with heads from the solution on all sides.
fem_reference::RichardsProblem manufactured_problem(const exact::Manufactured& box, int dim, int cells);

}  // namespace wetfront::verification
