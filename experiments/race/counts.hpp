// SPDX-License-Identifier: MIT
// What a kernel makes the processor do, counted by Valgrind's Callgrind: the same binary gives the same numbers on a
// loaded machine and on any other one. A process under Callgrind counts rivals and writes a file for each; the process that
// started it reads the files. Valgrind has no AVX-512, so that of kernels for several targets the AVX2 one is counted.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/race/rounds.hpp"

namespace bezierbench::race {

/// The options with which Callgrind counts what count() asks for.
inline constexpr std::string_view callgrind_options[]{"--tool=callgrind", "--collect-atstart=no", "--instr-atstart=no",
                                                      "--cache-sim=yes",  "--branch-sim=yes",     "--quiet"};

/// Per point.
struct Cost {
  double instructions = 0;
  double loads = 0;
  double stores = 0;
  double branches = 0;  ///< conditional and indirect ones
  std::string target;   ///< that of the batch kernel; empty for a kernel of one point

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.instructions, self.loads, self.stores, self.branches, self.target);
  }
};

/// False in a build without Valgrind's headers.
bool can_count();

/// Whether this process runs under Valgrind, where times mean nothing. False where can_count() is.
bool runs_under_valgrind();

/// Counts one batch of each rival of a part of a job, after one that is not counted. To be called under Callgrind.
void count(std::span<const Rival> rivals, std::size_t job, std::size_t part);

/// The counts of a job in Callgrind's files, by part and rival. Throws Failure(environment) for a file without them.
std::vector<std::vector<Cost>> read_counts(std::span<const std::string> files, std::size_t job);

}  // namespace bezierbench::race
