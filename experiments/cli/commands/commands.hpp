// SPDX-License-Identifier: MIT
// The subcommands: each adds its options and its action to the parser.
#pragma once

#include <span>
#include <string>

#include "experiments/cli/command.hpp"
#include "experiments/external/own_method.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {

/// `own`: methods that this program has beside those of the roster.
void add_run(Command program, Exit& exit, std::span<const external::OwnMethod> own);
void add_merge(Command program, Exit& exit);
void add_compare(Command program, Exit& exit);
void add_list(Command program, Exit& exit, std::span<const external::OwnMethod> own);
void add_verify(Command program, Exit& exit);
void add_replay(Command program, Exit& exit, std::span<const external::OwnMethod> own);
void add_report(Command program);
void add_choose(Command program, Exit& exit);
void add_check(Command program, Exit& exit, std::span<const external::OwnMethod> own);
void add_trials(Command program, Exit& exit);
void add_doctor(Command program, Exit& exit);
void add_inputs(Command program, Exit& exit);
void add_judge(Command program, Exit& exit);
void add_curve(Command program, Exit& exit);
void add_curves(Command program, Exit& exit);

/// The keys that every kind has, then those of each kind, in lines of at most 80 characters.
std::string kinds_text();

}  // namespace bezierbench::cli
