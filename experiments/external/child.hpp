// SPDX-License-Identifier: MIT
// A child process for external code, so that the code cannot change this process and its results.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace bezierbench::external {

/// Limits of one child process, which computes one block of trials.
struct Limits {
  double seconds = 10;             ///< of elapsed time
  std::uint64_t megabytes = 1024;  ///< of private writable memory, beyond that of this process
};

/// The limits of the process that describes a method at the start of a run: a busy machine may take long to start it.
inline Limits to_describe(Limits limits) {
  constexpr double min_seconds = 20;
  limits.seconds = std::max(limits.seconds, min_seconds);
  return limits;
}

enum class End { exited, signalled, timed_out, interrupted };

struct Ended {
  End end = End::exited;
  int code = 0;        ///< the exit code, or the number of the signal
  std::string output;  ///< what it wrote to its standard output
  std::string errors;  ///< the beginning of what it wrote to its standard error
};

/// Runs `work` in a fork of this process and waits for its end; when `work` returns, the child exits with code 0. Its
/// standard input is a file with `input`, its standard output and error are files, which together hold at most
/// `max_output` bytes each; every other file is closed. All signals have their default actions. The child leads a
/// process group, all of which is killed once the child has ended. `stop` is called meanwhile; true ends the child as
/// interrupted. May be called from any thread. Throws Failure(environment) where no process can be started.
Ended run_in_child(const std::function<void()>& work, std::string_view input, std::size_t max_output,
                   const Limits& limits, bool (*stop)());

/// In a child: a descriptor for its answer in place of standard output; what is printed from then on goes to standard
/// error.
int keep_output_for_answer();

/// Writes all bytes, or ends the child.
void write_all(int file, std::string_view bytes);

}  // namespace bezierbench::external
