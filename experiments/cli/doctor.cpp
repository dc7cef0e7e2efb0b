// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>

#include "build_facts.hpp"
#include "experiments/bundle/machine.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/floating_point.hpp"

namespace bezierbench::cli {

void add_doctor(CLI::App& app, Exit& exit) {
  app.add_subcommand("doctor", "is this machine fit to measure on?")->callback([&exit] {
    const auto faults = floating_point_faults();
    for (const auto& fault : faults) fmt::print("floating point: {}\n", fault);
    if (faults.empty()) fmt::print("floating point: IEEE 754 double, to nearest, no contraction, subnormals kept\n");
    fmt::print("{}", bundle::machine_json({compiler, all_flags, build_type, fp_flags, program_version}));
    exit = faults.empty() ? Exit::fine : Exit::environment;
  });
}

}  // namespace bezierbench::cli
