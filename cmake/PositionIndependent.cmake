# SPDX-License-Identifier: MIT
# libbezierbench.so is linked from the same libraries as the program. GCC mostly makes position-independent programs by
# default, and with optimisation most folders then need no option: only variables of a thread and exceptions of the
# standard library do, and such a folder says POSITION_INDEPENDENT. It does without the precompiled header, which is not
# compiled so. Kernels that are timed are thus compiled as for a program. In all other builds every folder is compiled
# for the library.
include(CheckCXXSourceCompiles)
check_cxx_source_compiles("#ifndef __PIC__\n#error\n#endif\nint main() {}" BEZIERBENCH_INDEPENDENT_BY_DEFAULT)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR NOT BEZIERBENCH_INDEPENDENT_BY_DEFAULT
   OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
