// SPDX-License-Identifier: MIT What a kernel makes the processor do, counted by Valgrind's Callgrind: the same binary
// gives the same numbers on a loaded machine and on any other one. A process under Callgrind counts rivals and writes a
// file for each; the process that started it reads the files. Valgrind has no AVX-512, so that of kernels for several
// targets the AVX2 one is counted.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/race/rounds.hpp"

namespace bezierbench::race {

/// The options with which Callgrind counts what count() asks for.
inline constexpr std::string_view callgrind_options[]{
    "--tool=callgrind", "--collect-atstart=no", "--instr-atstart=no", "--cache-sim=yes",       "--branch-sim=yes",
    "--quiet",          "--dump-instr=yes",     "--demangle=no",      "--compress-strings=no", "--compress-pos=no"};

/// Of a point, on a processor that is not here; see processor_models.hpp.
struct Cycles {
  double throughput = 0;  ///< the reciprocal one: where points do not wait for each other
  double latency = 0;  ///< where each instruction waits for those that it reads from, and each block for the last one

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.throughput, self.latency);
  }
};

/// Per point.
struct Cost {
  double instructions = 0;
  double loads = 0;
  double stores = 0;
  double branches = 0;              ///< conditional and indirect ones
  std::string target;               ///< that of the batch kernel; empty for a kernel of one point
  std::vector<Cycles> cycles = {};  ///< on each of `processors`, or none where they could not be predicted

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.instructions, self.loads, self.stores, self.branches, self.target, self.cycles);
  }
};

/// False in a build without Valgrind's headers.
bool can_count();

/// Whether this process runs under Valgrind, where times mean nothing. False where can_count() is.
bool runs_under_valgrind();

/// The rival of which a file of Callgrind has the counts.
struct Counted {
  std::size_t job = 0;
  std::size_t part = 0;
  std::size_t rival = 0;
  std::size_t points = 0;  ///< of the batch
  std::string target = {};
};

/// It, from the line of the file that says so; empty for other lines.
std::optional<Counted> counted_of(std::string_view line);

/// What a line of a file begins with that has the throughput and the latency of a point for each of `processors`.
inline constexpr std::string_view cycles_heading = "cycles:";

/// Counts one batch of each rival of a part of a job, after one that is not counted. To be called under Callgrind.
void count(std::span<const Rival> rivals, std::size_t job, std::size_t part);

/// The counts of a job in Callgrind's files, by part and rival. Throws Failure(environment) for a file without them.
std::vector<std::vector<Cost>> read_counts(std::span<const std::string> files, std::size_t job);

}  // namespace bezierbench::race
