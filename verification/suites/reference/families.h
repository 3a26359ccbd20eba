#pragma once

#include "verification/suites/case.h"

#include <vector>

/// The families of cases of `wetfront verify reference`, one file each, named after the first gate or subject.
namespace wetfront::verification {

std::vector<Case> steady_cases();             ///< R1
std::vector<Case> srivastava_yeh_cases();     ///< R2
std::vector<Case> two_layer_cases();          ///< R3
std::vector<Case> broadbridge_white_cases();  ///< R4
std::vector<Case> sorptivity_cases();         ///< R5
std::vector<Case> travelling_wave_cases();    ///< R6
std::vector<Case> tracy_cases();              ///< R7
std::vector<Case> celia_cases();              ///< R8
std::vector<Case> kirkland_cases();           ///< R9
std::vector<Case> dry_soil_cases();           ///< Yolo clay, caisson, Forsyth 2
std::vector<Case> rain_cases();               ///< ponding, sloping layer
std::vector<Case> flume_slope_cases();        ///< cost of the slope of the paper's size
std::vector<Case> manufactured_cases();       ///< the full operator, 1-D to 3-D
std::vector<Case> order_in_time_cases();      ///< each integrator
std::vector<Case> work_precision_cases();     ///< error over CPU seconds

}  // namespace wetfront::verification
