#pragma once

/// Written at build time by version.cmake.
namespace wetfront::verification::version {
extern const char* const number;
extern const char* const git_hash;
extern const char* const git_dirty;  ///< "true": the tree had uncommitted changes when this was built
extern const char* const compiler;
extern const char* const reference_code;  ///< hash of compiler and sources of the reference solver
}  // namespace wetfront::verification::version
