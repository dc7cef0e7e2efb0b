# SPDX-License-Identifier: MIT
# Writes the commit of the source tree, and whether the tree is clean, to a header; only when they changed.
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE commit ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
set(clean false)
if(failed)
  set(commit unknown)
else()
  execute_process(COMMAND git -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes STREQUAL "")
    set(clean true)
  endif()
endif()
set(text "// SPDX-License-Identifier: MIT
#pragma once

namespace bezierbench::cli {

inline constexpr const char* git_commit = \"${commit}\";
inline constexpr bool git_clean = ${clean};

}  // namespace bezierbench::cli
")
if(EXISTS ${OUT})
  file(READ ${OUT} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE ${OUT} "${text}")
endif()
