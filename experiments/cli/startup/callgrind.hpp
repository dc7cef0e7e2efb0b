// SPDX-License-Identifier: MIT
// Counting in a child: this program's command line again, under Valgrind's Callgrind.
#pragma once

#include <string>
#include <vector>

namespace bezierbench::cli {

/// Why instructions cannot be counted here: Valgrind is not installed, or was not when the program was built. Empty
/// where they can be.
[[nodiscard]] std::string why_uncounted();

/// The files in which Callgrind wrote the counts of this run, whose command line a child gives again; see
/// run::JobContext::count_jobs. Empty where a signal asked this program to end. Throws Failure(environment) where the child
/// fails.
[[nodiscard]] std::vector<std::string> counts_by_callgrind();

/// Whether this process is such a child.
[[nodiscard]] bool is_to_count();

}  // namespace bezierbench::cli
