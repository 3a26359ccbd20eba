#include "mpm/skeleton/make_soil_motion.h"
#include "mpm/skeleton/spline_shape.h"

namespace wetfront::mpm {

template std::unique_ptr<SoilMotion<3>> make_soil_motion(const Soil&, const SplineShape<3>&,
                                                         const SoilMotionSetting<3>&);

}  // namespace wetfront::mpm
