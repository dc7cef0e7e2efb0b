// SPDX-License-Identifier: MIT
// The subcommands: each adds its options to the parser and remembers what to do when it is chosen.
#pragma once

#include <CLI/CLI.hpp>

#include "experiments/failure.hpp"

namespace bezierbench::cli {

void add_run(CLI::App& app, Exit& exit);
void add_merge(CLI::App& app, Exit& exit);
void add_compare(CLI::App& app, Exit& exit);
void add_list(CLI::App& app, Exit& exit);
void add_verify(CLI::App& app, Exit& exit);
void add_replay(CLI::App& app, Exit& exit);
void add_choose(CLI::App& app, Exit& exit);
void add_trials(CLI::App& app, Exit& exit);
void add_doctor(CLI::App& app, Exit& exit);
void add_curve(CLI::App& app, Exit& exit);

}  // namespace bezierbench::cli
