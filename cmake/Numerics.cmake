# SPDX-License-Identifier: MIT
# The one place for the language level and the floating-point contract. Flags are part of the experiment: they are
# appended after the user's own, so that they win, and written to the provenance of every bundle.
set(CMAKE_CXX_EXTENSIONS OFF)
add_library(numerics INTERFACE)
target_compile_features(numerics INTERFACE cxx_std_20)
set(BEZIERBENCH_FP_FLAGS -fno-fast-math -ffp-contract=off)
target_compile_options(numerics INTERFACE ${BEZIERBENCH_FP_FLAGS} -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(numerics INTERFACE -Wno-stringop-overflow -Wno-array-bounds -Wno-restrict) # GCC imagines negative degrees
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    target_compile_options(numerics INTERFACE -Wno-maybe-uninitialized) # likewise; what GCC 12 says of it has been true
  endif()
  # No other library replaces a function of ours, so position-independent code may be inlined as in a program.
  target_compile_options(numerics INTERFACE -fno-semantic-interposition)
endif()
target_link_options(numerics INTERFACE -fno-fast-math) # -ffast-math at link time would flush subnormals to zero
target_compile_definitions(numerics INTERFACE EIGEN_DONT_VECTORIZE BEZIERBENCH_SLOW_FMA)
target_include_directories(numerics INTERFACE ${PROJECT_SOURCE_DIR})
string(JOIN " " BEZIERBENCH_FP_FLAGS_TEXT ${BEZIERBENCH_FP_FLAGS})

option(BEZIERBENCH_X86_64_V3 "on x86-64, target x86-64-v3 (AVX2 and fused multiply-add in hardware)" OFF)
if(BEZIERBENCH_X86_64_V3 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  target_compile_options(numerics INTERFACE -march=x86-64-v3)
endif()
