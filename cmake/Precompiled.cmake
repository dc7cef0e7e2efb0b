# SPDX-License-Identifier: MIT
# What most files include and what takes long to parse is parsed once for each set of options of the optimiser, which GCC
# takes from a precompiled header and not from the command line. A file includes what it uses nevertheless: Clang compiles
# without this, and finds what is missing.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC's garbage collection begins at 512 MB instead of 128 MB: a tenth less time for a hundred megabytes more.
  add_compile_options(--param=ggc-min-heapsize=524288)
else()
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(BEZIERBENCH_PRECOMPILED <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
                            <optional> <random> <ranges> <set> <span> <sstream> <string> <string_view> <utility>
                            <variant> <vector> <Eigen/Core>)
# Of the packages that this build has.
set(header_of_random123 <Random123/philox.h>)
set(header_of_fmt::fmt <fmt/format.h>)
set(header_of_gmp <gmpxx.h>)
set(precompiled_packages Eigen3::Eigen)
foreach(package random123 fmt::fmt gmp)
  if(TARGET ${package})
    list(APPEND precompiled_packages ${package})
    list(APPEND BEZIERBENCH_PRECOMPILED ${header_of_${package}})
    # GCC takes a precompiled header only where the definitions that it looks at are those that it was compiled with.
    target_compile_definitions(numerics INTERFACE $<TARGET_PROPERTY:${package},INTERFACE_COMPILE_DEFINITIONS>)
  endif()
endforeach()
# Options of tests, which run for seconds and compile for minutes, and of folders that say LIGHT (Folder.cmake).
set(BEZIERBENCH_LIGHT_OPTIONS $<$<CONFIG:Release>:-O1>)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")

# bezierbench_precompiled(NAME [OPTIONS option...] HEADERS header...): a target whose precompiled header others reuse.
function(bezierbench_precompiled name)
  cmake_parse_arguments(PRECOMPILED "" "" "OPTIONS;HEADERS" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${name} PUBLIC numerics PRIVATE ${precompiled_packages})
  target_compile_options(${name} PRIVATE ${PRECOMPILED_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${PRECOMPILED_HEADERS})
endfunction()

bezierbench_precompiled(precompiled HEADERS ${BEZIERBENCH_PRECOMPILED})
bezierbench_precompiled(precompiled_light OPTIONS ${BEZIERBENCH_LIGHT_OPTIONS} HEADERS ${BEZIERBENCH_PRECOMPILED})
if(BEZIERBENCH_TESTS)
  bezierbench_precompiled(precompiled_tests OPTIONS ${BEZIERBENCH_LIGHT_OPTIONS}
                          HEADERS ${BEZIERBENCH_PRECOMPILED} <gmock/gmock.h> <gtest/gtest.h>)
  target_link_libraries(precompiled_tests PUBLIC GTest::gmock)
  # Test programs are compiled with -fPIE, and their precompiled header must be, too.
  set_target_properties(precompiled_tests PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(precompiled_tests PRIVATE -fPIE)
endif()
