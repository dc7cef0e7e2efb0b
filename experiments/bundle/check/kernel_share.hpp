// SPDX-License-Identifier: MIT
// How many of a bundle's accuracy results come from the same kernels that are timed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace bezierbench::bundle {

/// Counts of evaluations in accuracy studies; one evaluation is one method in one trial. Groups of trials may be
/// evaluated by another kernel, which is compared bit for bit with the method's own from time to time.
struct KernelShare {
  std::uint64_t judged = 0;
  std::uint64_t own = 0;  ///< by the kernel that is timed, alone or beside that of a group
};

/// The counts in reference.csv. Empty for a bundle without accuracy studies, and for one of an older program that did
/// not count. Throws Failure(Exit::input_output) for a table that cannot be read or a field that is not a count.
[[nodiscard]] std::optional<KernelShare> kernel_share(const std::filesystem::path& path);

}  // namespace bezierbench::bundle
