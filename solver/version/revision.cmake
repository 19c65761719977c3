# Run at every build: writes OUT (C++) with the commit of SOURCE; touches it only if the commit or its cleanness changed.
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
set(dirty false)
if(failed)
  set(revision unknown)
else()
  execute_process(COMMAND git -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes)
    set(dirty true)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT [[
// Generated at build time: the commit that the sources belong to.
#include "solver/version/version.hpp"

namespace talus {

const char* const source_revision = "@revision@";
const bool source_dirty = @dirty@;

}  // namespace talus
]] @ONLY)
