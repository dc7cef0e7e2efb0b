// SPDX-License-Identifier: MIT
// The whole program, for main.cpp and for users' programs that have methods of their own.
#pragma once

#include <span>

#include "experiments/outside/own.hpp"

namespace bezierbench::cli {

/// Runs the command line; returns the exit code. `own` are judged in every run beside the methods of the roster.
int main(int argc, char** argv, std::span<const outside::OwnMethod> own);

}  // namespace bezierbench::cli
