// SPDX-License-Identifier: MIT
// `inputs`: the inputs of accuracy studies as CSV, for answers from anywhere.
#include <fmt/format.h>

#include <memory>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/outside/input_table.hpp"
#include "experiments/cli/startup/suites_folder.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/cli/terminal/whole_number.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/overrides.hpp"
#include "experiments/suite/reader.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::cli {
namespace {

struct InputsOptions {
  std::vector<std::string> suites;
  std::string out;
  std::optional<std::string> seed;
  std::optional<std::string> trials;
  suite::Overrides overrides;
};

void write_inputs(InputsOptions options) {
  if (options.out.empty()) throw Failure(Exit::usage, "--out: is empty; name a file");
  if (options.seed) options.overrides.seed = static_cast<std::uint64_t>(whole_number("--seed", *options.seed));
  if (options.trials) options.overrides.trials = whole_number("--trials", *options.trials);
  const auto known = vocabulary();
  std::vector<suite::Suite> suites;
  for (const auto& word : options.suites) {
    const auto file = suite_file(word).string();
    for (auto& one : suite::read_suites(file, known)) suites.push_back(std::move(one));
    suite::check_unique_ids(suites, file);
  }
  suite::apply(options.overrides, suites, known);
  bundle::write_file(options.out, input_table(suites).text());
}

}  // namespace

void add_inputs(Command program, Exit& exit) {
  auto options = std::make_shared<InputsOptions>();
  auto command = program.command("inputs", "the inputs of a suite's accuracy studies as CSV, to be answered elsewhere");
  command.option("suites", options->suites, "ids of suites that come with the program, or files").required();
  command.option("--out", options->out, "file that is written").required();
  command.option("--seed", options->seed, "another seed than the suite's");
  command.option("--trials", options->trials, "trials per cell");
  command.option("--set", options->overrides.set, "key=v1,v2 for every study; intervals as 0:0.2");
  command.option("--only", options->overrides.only, "only studies whose id matches this glob");
  command.action([options, &exit] {
    write_inputs(*options);
    exit = Exit::fine;
  });
}

}  // namespace bezierbench::cli
