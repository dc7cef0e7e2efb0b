// SPDX-License-Identifier: MIT
// A method that is a command: `--program 'python3 mine.py'`. It is started once for each batch, reads inputs from its
// standard input and writes answers to its standard output; docs/own_method.md describes both to the letter.
#pragma once

#include <memory>
#include <string>

#include "experiments/outside/child.hpp"
#include "experiments/outside/method.hpp"

namespace bezierbench::outside {

/// Starts the command once, with no inputs, to learn its id. Throws Failure(usage) where it does not answer as it
/// should, with what it said.
std::shared_ptr<const Method> program(const std::string& command, const Limits& limits, bool (*stop)());

/// What a program reads for a batch: a line `bezierbench-program 1 FORM DIMENSION DEGREE COUNT`, then a line for each
/// input: t, the coefficients point by point, then the weights.
std::string program_input(const Batch& batch);

}  // namespace bezierbench::outside
