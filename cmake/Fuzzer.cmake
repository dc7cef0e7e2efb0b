# SPDX-License-Identifier: MIT
# bezierbench_fuzzer(PATH DEPENDS target... CORPUS file... [SOURCES file...]): PATH_fuzz.cpp becomes a fuzzer, which
# has the name of the file. Under the preset `fuzz` that is libFuzzer's, for scripts/check fuzz; elsewhere a test gives it
# the files of the corpus and thousands of changed ones.
option(BEZIERBENCH_LIBFUZZER "link the fuzzers with libFuzzer (Clang)" OFF)
add_custom_target(fuzzers)

function(bezierbench_fuzzer path)
  get_filename_component(name ${path} NAME)
  cmake_parse_arguments(FUZZER "" "" "DEPENDS;CORPUS;SOURCES" ${ARGN})
  if(NOT BEZIERBENCH_TESTS)
    return()
  endif()
  add_executable(${name}_fuzzer ${path}_fuzz.cpp ${FUZZER_SOURCES})
  target_link_libraries(${name}_fuzzer PRIVATE ${FUZZER_DEPENDS})
  set_target_properties(${name}_fuzzer PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/fuzzers)
  add_dependencies(fuzzers ${name}_fuzzer)
  if(BEZIERBENCH_LIBFUZZER)
    target_link_options(${name}_fuzzer PRIVATE -fsanitize=fuzzer)
    file(COPY ${FUZZER_CORPUS} DESTINATION ${PROJECT_BINARY_DIR}/fuzzers/${name}_seeds)
  else()
    target_sources(${name}_fuzzer PRIVATE ${PROJECT_SOURCE_DIR}/experiments/fuzzing/mutation_driver.cpp)
    add_test(NAME fuzz_${name} COMMAND ${name}_fuzzer ${FUZZER_CORPUS})
    set_tests_properties(fuzz_${name} PROPERTIES TIMEOUT ${BEZIERBENCH_TEST_SECONDS})
  endif()
endfunction()
