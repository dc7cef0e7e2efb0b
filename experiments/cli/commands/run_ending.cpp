// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/run_ending.hpp"

#include <fmt/format.h>

#include "experiments/cli/startup/suites_folder.hpp"
#include "experiments/cli/terminal/shell_word.hpp"
#include "experiments/run/progress.hpp"

namespace bezierbench::cli {

std::vector<std::string> next_commands(const run::Outcome& outcome, const std::string& out) {
  if (outcome.ending == run::Ending::partial) return {};  // other shards are to be run, wherever their machines are
  std::vector<std::string> commands;
  if (const auto report = script_of_source("report"); !report.empty())
    commands.push_back(fmt::format("{} {}", shell_word(report.string()), shell_word(out)));
  commands.push_back(fmt::format("{} verify {}", this_program(), shell_word(out)));
  return commands;
}

void tell_ending(const run::Outcome& outcome, const std::string& out, run::Telling telling) {
  if (telling == run::Telling::json)
    return run::note_event(run::ending_json(outcome, out, next_commands(outcome, out)));
  if (telling == run::Telling::nothing || outcome.ending != run::Ending::complete) return;
  run::note(fmt::format("{}: {}", out, run::ending_line(outcome)));
  run::note(fmt::format("next: {}", next_commands(outcome, out).front()));
}

}  // namespace bezierbench::cli
