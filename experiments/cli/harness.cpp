// SPDX-License-Identifier: MIT
#include "experiments/outside/harness.hpp"

#include "experiments/cli/program.hpp"

namespace bezierbench::harness {

int run(int argc, char** argv, std::span<const outside::OwnMethod> own) { return cli::main(argc, argv, own); }

}  // namespace bezierbench::harness
