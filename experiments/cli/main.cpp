// SPDX-License-Identifier: MIT Compiled for plain x86-64, unlike the rest, and its check of the processor runs before
// any other initialiser, so that the message comes before the first instruction that the processor does not have.
#include <unistd.h>

#include <cstdlib>

#include "experiments/external/harness.hpp"

namespace {

/// Whether this processor has the instructions that the program was compiled for (x86-64-v3 with the presets).
bool processor_suffices() {
#ifdef BEZIERBENCH_NEEDS_X86_64_V3
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
         __builtin_cpu_supports("bmi2") != 0;
#else
  return true;
#endif
}

constexpr int earliest_priority = 101;

[[gnu::constructor(earliest_priority)]] void stop_on_lesser_processor() {
  if (processor_suffices()) return;
  constexpr char message[] =
      "bezierbench: this processor has no AVX2 or FMA, for which the program was built; configure with "
      "-DBEZIERBENCH_X86_64_V3=OFF\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof(message) - 1);
  _exit(3);
}

}  // namespace

int main(int argc, char** argv) { return bezierbench::harness::run(argc, argv, {}); }
