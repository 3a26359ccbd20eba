#pragma once

#include "meshes/mesh.h"

#include <map>
#include <string>

namespace wetfront::verification {

/// Where a result came from: git_hash, dirty, version, input_hash, mesh_hash, compiler, isa, threads, cpu, date.
/// `input` is the text that defined the run (a scene file, a case name).
std::map<std::string, std::string> provenance(const std::string& input, const meshes::Mesh& mesh);

}  // namespace wetfront::verification
