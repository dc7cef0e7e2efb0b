# SPDX-License-Identifier: MIT
# What most files include and what takes long to parse is parsed once, for libraries and for tests. A file includes what it
# uses all the same: Clang compiles without this, and finds what is missing.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(BEZIERBENCH_PRECOMPILED <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
                            <optional> <random> <ranges> <set> <span> <sstream> <string> <string_view> <utility>
                            <variant> <vector> <Eigen/Core> <Random123/philox.h> <fmt/format.h> <gmpxx.h>)
# GCC takes a precompiled header only where the definitions that it looks at are those that it was compiled with.
target_compile_definitions(numerics INTERFACE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
# Of tests, which run for seconds and compile for minutes. Never of a library: the linker keeps one copy of a template that
# several objects instantiate, and the one that is timed would be the less optimised.
set(BEZIERBENCH_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")

add_library(precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(precompiled PUBLIC numerics PRIVATE Eigen3::Eigen fmt::fmt gmp random123)
target_precompile_headers(precompiled PRIVATE ${BEZIERBENCH_PRECOMPILED})

if(BEZIERBENCH_TESTS)
  add_library(precompiled_tests OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(precompiled_tests PUBLIC numerics GTest::gmock PRIVATE Eigen3::Eigen fmt::fmt gmp random123)
  target_compile_options(precompiled_tests PRIVATE ${BEZIERBENCH_TEST_OPTIONS})
  target_precompile_headers(precompiled_tests PRIVATE ${BEZIERBENCH_PRECOMPILED} <gmock/gmock.h> <gtest/gtest.h>)
endif()
