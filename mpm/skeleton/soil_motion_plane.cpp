#include "mpm/skeleton/make_soil_motion.h"

namespace wetfront::mpm {

template std::unique_ptr<SoilMotion<2>> make_soil_motion(const Soil&, const LinearShape<2>&,
                                                         const SoilMotionSetting<2>&);

}  // namespace wetfront::mpm
