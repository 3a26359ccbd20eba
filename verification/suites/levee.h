#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::verification {

/// The levee of cases/levee: 3 m high, crown of 2 m, slopes 1:2 down to edges of 0.25 m, 14 m wide, on impermeable
/// ground. Sandy loam. The water on the left rises from 0.25 to 2.4 m within 12 h and stays; the landside slope and
/// edge are a seepage face under 1 mm/h of rain, which falls on the crown and on the waterside slope above the water
/// too. Hydrostatic over y = 0.25 m at the start; 4 days. `cells_along` a multiple of 7, so that kinks are nodes.
fem_reference::RichardsProblem levee(int cells_along, int cells_over);

}  // namespace wetfront::verification
