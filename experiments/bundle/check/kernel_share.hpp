// SPDX-License-Identifier: MIT
// How much of what a bundle says of accuracy comes from the very kernels that are timed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace bezierbench::bundle {

/// Evaluations that accuracy studies judged: a method at one trial each. Groups of trials may go through a kernel of
/// their own, which is compared with the method's bit for bit now and then.
struct KernelShare {
  std::uint64_t judged = 0;
  std::uint64_t own = 0;  ///< by the method's own kernel, the one that is timed: alone, or beside that of a group
};

/// From reference.csv. Nothing for a bundle without accuracy studies, or of an older program, which did not count.
/// Throws Failure(Exit::input_output) for a table that cannot be read or a field that is no count.
[[nodiscard]] std::optional<KernelShare> kernel_share(const std::filesystem::path& path);

}  // namespace bezierbench::bundle
