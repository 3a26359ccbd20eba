#pragma once

#include "mpm/body_record.h"
#include "reports/record.h"
#include "verification/scene/scene.h"

#include <vector>

namespace wetfront::verification {

/// The body's pictures as a film of its points, coloured by displacement since the run began and, where there is water,
/// by pore pressure and degree of saturation. Empty in three dimensions and where there are less than two pictures.
std::vector<reports::Film> body_films(const Scene& scene, const meshes::FieldHistory& history,
                                      const mpm::BodyRecord& body);

}  // namespace wetfront::verification
