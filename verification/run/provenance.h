#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

#include <map>
#include <string>

namespace wetfront::verification {

/// Where a result came from: git_hash, dirty, version, input_hash, mesh_hash, compiler, isa, threads, cpu, date.
std::map<std::string, std::string> provenance(const Scene& scene, const meshes::Mesh& mesh);

}  // namespace wetfront::verification
