#pragma once

#include "verification/present/slide_figures.h"
#include "verification/run/run_scene.h"

#include <optional>

namespace wetfront::verification {

/// The same scene on cells of another size; none where the scene asks for none, or where either run ended before its
/// time: half a slide is no measure of doubt. Nothing it meets may lose the run that is there.
std::optional<OnSecondMesh> on_second_mesh(const Prepared& prepared, RunResult& result);

}  // namespace wetfront::verification
