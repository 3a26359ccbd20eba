#pragma once

#include "meshes/mesh.h"

#include <map>
#include <string>

namespace wetfront::verification {

/// Where a result came from: git_hash, dirty, version, input_hash, mesh_hash, compiler, isa, threads, cpu, date.
/// `input` is the text that defined the run (a scene file, a case name); `threads` those of the MPM's kernels, 1 where
/// the reference alone ran.
std::map<std::string, std::string> provenance(const std::string& input, const meshes::Mesh& mesh, int threads);

}  // namespace wetfront::verification
