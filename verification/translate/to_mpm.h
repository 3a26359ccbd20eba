#pragma once

#include "mpm/problem.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

namespace wetfront::verification {

/// The scene as the material point method sees it (pressures, intrinsic permeability). `mesh` is `mpm_mesh(scene)`.
mpm::Problem<2> to_mpm(const Scene& scene, const meshes::Mesh& mesh, const Timeline& timeline);

}  // namespace wetfront::verification
