// SPDX-License-Identifier: MIT
// The properties of file readers that fuzzers check. Where one does not hold, the program aborts, which the fuzzer
// reports.
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

/// True where `read()` succeeds. It may refuse with a Failure of the given exit code that names the file; any other
/// exception ends the program.
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

/// The function that libFuzzer and mutation_driver.cpp call with every input; returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
