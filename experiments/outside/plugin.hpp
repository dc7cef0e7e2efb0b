// SPDX-License-Identifier: MIT
// A method that is a shared object: `--plugin ./mine.so`, with the interface of plugin.h.
#pragma once

#include <filesystem>
#include <memory>

#include "experiments/outside/child.hpp"
#include "experiments/outside/method.hpp"

namespace bezierbench::outside {

/// Loads the shared object in a child process, to learn what it says of its method; this process never loads it.
/// Throws Failure(usage) where it is none, Failure(input_output) where the file cannot be read.
std::shared_ptr<const Method> plugin(const std::filesystem::path& file, const Limits& limits, bool (*stop)());

}  // namespace bezierbench::outside
