# cmake -DSOURCE=... -DOUTPUT=... -DVERSION=... -DCOMPILER=... -P version.cmake
# Runs at every build, so that a report names the commit it was built from, not the one last configured.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
# What a stored reference depends on besides its problem.
file(GLOB_RECURSE code ${SOURCE}/fem_reference/*.cpp ${SOURCE}/fem_reference/*.h ${SOURCE}/meshes/*.cpp ${SOURCE}/meshes/*.h)
list(SORT code)
set(sums "${COMPILER}")
foreach(file IN LISTS code)
  file(SHA256 ${file} sum)
  string(APPEND sums ${sum})
endforeach()
string(SHA256 reference_code "${sums}")
if(NOT hash)
  set(hash "unknown (not a git checkout)")
endif()
if(changes)
  set(dirty "true")
else()
  set(dirty "false")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "verification/run/version.h"
namespace wetfront::verification::version {
const char* const number = "@VERSION@";
const char* const git_hash = "@hash@";
const char* const git_dirty = "@dirty@";
const char* const compiler = "@COMPILER@";
const char* const reference_code = "@reference_code@";
}  // namespace wetfront::verification::version
]] @ONLY)
