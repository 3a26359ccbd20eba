# cmake -DSOURCE=... -DOUTPUT=... -DVERSION=... -DCOMPILER=... -P version.cmake
# Runs at every build, so that a report names the commit it was built from, not the one last configured.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
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
}  // namespace wetfront::verification::version
]] @ONLY)
