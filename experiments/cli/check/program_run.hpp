// SPDX-License-Identifier: MIT
// A run of a suite by another build of this program.
#pragma once

#include <filesystem>

namespace bezierbench::cli {

/// `PROGRAM run SUITE --out OUT --quiet`. Violated bounds are no failure: the bundle says them. Throws
/// Failure(Exit::usage) where the program ends with any other code.
void run_suite(const std::filesystem::path& program, const std::filesystem::path& suite,
               const std::filesystem::path& out);

}  // namespace bezierbench::cli
