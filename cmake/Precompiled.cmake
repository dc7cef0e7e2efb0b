# SPDX-License-Identifier: MIT
# What most files include is parsed once, for libraries and for tests. A file includes what it uses all the same: Clang
# compiles without this, and finds what is missing.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(BEZIERBENCH_PRECOMPILED <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
                            <optional> <random> <ranges> <span> <sstream> <string> <string_view> <utility> <vector>)
# Of tests, which run for seconds and compile for minutes. Never of a library: the linker keeps one copy of a template that
# several objects instantiate, and the one that is timed would be the less optimised.
set(BEZIERBENCH_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")

add_library(precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(precompiled PUBLIC numerics)
target_precompile_headers(precompiled PRIVATE ${BEZIERBENCH_PRECOMPILED})

if(BEZIERBENCH_TESTS)
  add_library(precompiled_tests OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(precompiled_tests PUBLIC numerics GTest::gmock)
  target_compile_options(precompiled_tests PRIVATE ${BEZIERBENCH_TEST_OPTIONS})
  target_precompile_headers(precompiled_tests PRIVATE ${BEZIERBENCH_PRECOMPILED} <gmock/gmock.h> <gtest/gtest.h>)
endif()
