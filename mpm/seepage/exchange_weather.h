#pragma once

#include "mpm/problem.h"

namespace wetfront::mpm {

/// What a condition does during one step, per area that it acts on.
struct Weather {
  double offered = 0, demanded = 0;  ///< water [m/s, >= 0]
  double least_pressure = 0;         ///< of the demand [Pa]
};

/// Rain, evaporation and flux of a condition in a step that begins at `begin`: steps end where these change.
Weather weather_of(const WaterBoundary& condition, double begin);

/// The condition offers water to, or demands it from, the soil through the surface film.
bool exchanges(const WaterBoundary& condition);
/// Some rain, or some evaporation, is asked for: a horizontal area has to be there.
bool wants_sky(const WaterBoundary& condition);
/// Times at which what a condition asks for, or holds, changes abruptly or changes its slope [s].
std::vector<double> breaks_of(const WaterBoundary& condition);
/// Throws CannotPlan when a head or a level has no record. (Numbers are checked before: plan/check_numbers.h.)
void check_condition(const WaterBoundary& condition);

}  // namespace wetfront::mpm
