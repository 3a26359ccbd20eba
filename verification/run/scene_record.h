#pragma once

#include "meshes/mesh.h"
#include "reports/record.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// What every page about a scene begins with: its name, title, requirement, path, text and provenance.
reports::Record record_of(const Scene& scene, const meshes::Mesh& mesh);

}  // namespace wetfront::verification
