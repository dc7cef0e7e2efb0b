// SPDX-License-Identifier: MIT
// `inputs`: the inputs of accuracy studies as CSV, for answers from anywhere.
#include <memory>
#include <string>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/outside/input_table.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {
namespace {

struct InputsOptions {
  SuiteOptions suites;
  std::string out;
};

void write_inputs(const InputsOptions& options) {
  if (options.out.empty()) throw Failure(Exit::usage, "--out: is empty; name a file");
  bundle::write_file(options.out, input_table(options.suites.read(vocabulary())).text());
}

}  // namespace

void add_inputs(Command program, Exit& exit) {
  auto options = std::make_shared<InputsOptions>();
  auto command = program.command("inputs", "the inputs of a suite's accuracy studies as CSV, to be answered elsewhere");
  options->suites.add_suites(command);
  command.option("--out", options->out, "file that is written").required().takes(file_value);
  options->suites.add_changes(command);
  command.action([options, &exit] {
    write_inputs(*options);
    exit = Exit::fine;
  });
}

}  // namespace bezierbench::cli
