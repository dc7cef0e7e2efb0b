// SPDX-License-Identifier: MIT
// Counts are taken in a child process, which is this program with the same command line under Valgrind's Callgrind.
#pragma once

#include <string>
#include <vector>

namespace bezierbench::cli {

/// Why this program cannot count instructions, and what to do about it: Valgrind is not installed, its headers were not
/// there when the program was built, or the program has a sanitizer. Empty where it can count.
[[nodiscard]] std::string why_uncounted();

/// Runs such a child and returns the files with its counts, and with the cycles that llvm-mca predicts from these where
/// it is installed; see run::JobContext::count_jobs. Empty where a signal
/// asked this program to end. Throws Failure(environment) where the child fails.
[[nodiscard]] std::vector<std::string> counts_by_callgrind();

/// Whether this process is such a child.
[[nodiscard]] bool is_to_count();

}  // namespace bezierbench::cli
