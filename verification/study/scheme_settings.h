#pragma once

#include "verification/scene/scene.h"
#include "verification/scene/set_value.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// What makes another scheme run the last stage of a scene: "seepage", "semi-implicit", "implicit-drag", "explicit";
/// `integrator` of seepage, empty: the usual one. A deforming skeleton moves in true time under two velocities, from
/// the equilibrium that a quasi-static stage would have begun with.
std::vector<Setting> scheme_settings(const Scene& scene, const std::string& scheme, const std::string& integrator = "");

/// Whether a scheme has an error control in time.
bool controls_its_error(const std::string& scheme);

/// "stage[1].": where settings of the last stage begin.
std::string last_stage(const Scene& scene);

}  // namespace wetfront::verification
