// SPDX-License-Identifier: MIT
// Counting in a child: this program's command line again, under Valgrind's Callgrind.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bezierbench::cli {

/// Why instructions cannot be counted here: Valgrind is not installed, or was not when the program was built. Empty
/// where they can be.
[[nodiscard]] std::string why_uncounted();

/// The files in which Callgrind wrote the counts of one job of this run, whose command line a child gives again; see
/// run::JobContext::count_job. Throws Failure(environment) where the child fails, and Failure(interrupted).
[[nodiscard]] std::vector<std::string> counts_by_callgrind(std::size_t job);

/// The job that this process is to count, if it is such a child.
[[nodiscard]] std::optional<std::size_t> job_to_count();

}  // namespace bezierbench::cli
