# SPDX-License-Identifier: MIT
# bezierbench_folder(NAME [FOLDER folder] [SUBFOLDERS] [WITH folder...] [LIGHT] [JOINED n] [JOINED_TESTS n]
# [PRECOMPILED target] DEPENDS target...): the sources of FOLDER, or else of this folder, with SUBFOLDERS those of the folders
# in it, and those of its folders WITH, become the library NAME, their *_test.cpp the test program NAME_test. Files are
# globbed so that adding a method or a study needs no second list. PRECOMPILED names the target whose precompiled header and
# options the folder has.
#
# LIGHT is for folders that neither are timed nor judge trials: a third of the time to compile them is saved by less
# optimisation. The linker keeps the first copy of a template that several objects instantiate, so the program links the
# objects of all other folders first, which are in the global property BEZIERBENCH_FULLY_OPTIMISED.
#
# With JOINED GCC compiles up to n sources as one translation unit, with JOINED_TESTS up to n tests, since most of a short
# one's time goes into what it includes. Names in the unnamed namespaces of such a folder are different from each other.
# An error names the source, and Clang compiles each source by itself. Kernels and what times them are never joined:
# no code of a caller may be inlined into them, or the reverse.
option(BEZIERBENCH_JOINED "compile the short sources of a folder together (GCC)" ON)
# Does so for a target. Without a number each source is compiled by itself.
function(bezierbench_join target number)
  if(number AND BEZIERBENCH_JOINED AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${number})
  endif()
endfunction()

# CTest starts the costly first, so that none is left to run alone at the end: a test of the program takes seconds.
set(BEZIERBENCH_PROGRAM_TEST_COST 20)
set(BEZIERBENCH_LONGEST_TEST_COST 200)

# The program of a folder's tests is one CTest of the same name: thousands of processes, one for each test, would take half a
# minute to start. --gtest_brief shows what fails only.
function(bezierbench_test_program target)
  add_test(NAME ${target} COMMAND ${target} --gtest_brief=1)
  set_tests_properties(${target} PROPERTIES TIMEOUT ${BEZIERBENCH_TEST_SECONDS} COST ${BEZIERBENCH_PROGRAM_TEST_COST})
endfunction()

function(bezierbench_folder name)
  cmake_parse_arguments(FOLDER "SUBFOLDERS;LIGHT" "FOLDER;JOINED;JOINED_TESTS;PRECOMPILED" "WITH;DEPENDS;TEST_DEPENDS" ${ARGN})
  set(patterns *.cpp)
  if(FOLDER_SUBFOLDERS)
    list(APPEND patterns */*.cpp)
  endif()
  foreach(folder IN LISTS FOLDER_WITH)
    list(APPEND patterns ${folder}/*.cpp)
  endforeach()
  if(FOLDER_FOLDER)
    list(TRANSFORM patterns PREPEND ${FOLDER_FOLDER}/)
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "(_test|_fuzz|/main)\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC numerics ${FOLDER_DEPENDS})
    if(FOLDER_LIGHT)
      set(FOLDER_PRECOMPILED precompiled_light)
    else()
      set_property(GLOBAL APPEND PROPERTY BEZIERBENCH_FULLY_OPTIMISED $<TARGET_OBJECTS:${name}>)
    endif()
    if(FOLDER_PRECOMPILED)
      target_compile_options(${name} PRIVATE $<TARGET_PROPERTY:${FOLDER_PRECOMPILED},COMPILE_OPTIONS>)
    else()
      set(FOLDER_PRECOMPILED precompiled)
    endif()
    target_precompile_headers(${name} REUSE_FROM ${FOLDER_PRECOMPILED})
    bezierbench_join(${name} "${FOLDER_JOINED}")
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE numerics ${FOLDER_DEPENDS})
  endif()
  if(tests AND BEZIERBENCH_TESTS)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE ${name} ${FOLDER_TEST_DEPENDS} GTest::gmock GTest::gtest_main)
    set_target_properties(${name}_test PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
    target_compile_options(${name}_test PRIVATE ${BEZIERBENCH_LIGHT_OPTIONS})
    target_precompile_headers(${name}_test REUSE_FROM precompiled_tests)
    bezierbench_join(${name}_test "${FOLDER_JOINED_TESTS}")
    target_compile_definitions(${name}_test PRIVATE BEZIERBENCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    bezierbench_test_program(${name}_test)
  endif()
endfunction()
