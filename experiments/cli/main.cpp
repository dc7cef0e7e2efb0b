// SPDX-License-Identifier: MIT
#include "experiments/cli/program.hpp"

int main(int argc, char** argv) { return bezierbench::cli::main(argc, argv, {}); }
