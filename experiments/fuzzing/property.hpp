// SPDX-License-Identifier: MIT
// What a fuzzer holds a reader of files to. Where it does not hold, the program ends so that the fuzzer notices.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "experiments/failure.hpp"

namespace bezierbench::fuzzing {

inline constexpr const char* file_name = "fuzzed.file";

inline void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what.c_str());
  std::abort();
}

/// Whether `read()` reads. A refusal must be the Failure of the given exit code that names the file; any other
/// exception goes on its way and ends the program.
template <class Read>
bool reads(Exit refusal, Read read) {
  try {
    read();
    return true;
  } catch (const Failure& failure) {
    require(failure.exit() == refusal, std::string("the exit code of: ") + failure.what());
    require(std::string_view(failure.what()).starts_with(file_name),
            std::string("the file is named: ") + failure.what());
    return false;
  }
}

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace bezierbench::fuzzing

/// What libFuzzer calls with every input, and mutation_driver.cpp too; 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
