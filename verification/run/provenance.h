#pragma once

#include "meshes/field_history.h"

#include <map>
#include <string>

namespace wetfront::verification {

/// Where a result came from: git_hash, dirty, version, input_hash, mesh_hash, compiler, isa, threads, cpu, date.
/// `input` is the text that defined the run (a scene file, a case name); `threads` those of the MPM's kernels, 1 where
/// the reference alone ran.
std::map<std::string, std::string> provenance(const std::string& input, const meshes::Mesh& mesh, int threads);

/// One, whatever the scene gives the MPM; "1 on each of 4 ranks" where mpirun shared the solve among them.
std::string threads_of_reference(const meshes::FieldHistory& reference);

}  // namespace wetfront::verification
