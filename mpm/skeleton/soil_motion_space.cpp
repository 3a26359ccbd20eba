#include "mpm/skeleton/make_soil_motion.h"

namespace wetfront::mpm {

template std::unique_ptr<SoilMotion<3>> make_soil_motion(const Soil&, const LinearShape<3>&,
                                                         const SoilMotionSetting<3>&);

}  // namespace wetfront::mpm
