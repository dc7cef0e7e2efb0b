// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/diagnostics.hpp"
#include "experiments/cli/floating_point.hpp"
#include "experiments/cli/vocabulary.hpp"
#include "experiments/suite/nearest.hpp"

namespace {

using bezierbench::Exit;
using bezierbench::Failure;

int fail(Exit exit, const std::string& line) {
  bezierbench::cli::say(line);
  return static_cast<int>(exit);
}

/// A standard stream that is closed would give its number to the next file that is opened, a result: occupies it with
/// one that fails just as well.
void occupy_closed_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) == -1) open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// What is wrong with the command line. The parser says only that a subcommand is missing where one is unknown.
std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const auto words = app.remaining(true);
  if (command->get_require_subcommand_min() == 0 || words.empty()) return error.what();
  std::vector<std::string> known;
  for (const auto* subcommand : command->get_subcommands({})) known.push_back(subcommand->get_name());
  return fmt::format("{}: unknown{}", words.front(), bezierbench::suite::suggestion(words.front(), known));
}

int standard_output_failed() {
  return fail(Exit::input_output, "standard output: cannot be written; free space or choose another place");
}

int run_program(int argc, char** argv) {
  CLI::App app{"How wrong is each way of evaluating a Bezier curve, and how fast is it here?", "bezierbench"};
  app.require_subcommand(1);
  app.set_version_flag("--version", bezierbench::cli::version_line());
  Exit exit = Exit::fine;
  bezierbench::cli::add_run(app, exit);
  bezierbench::cli::add_merge(app, exit);
  bezierbench::cli::add_compare(app, exit);
  bezierbench::cli::add_list(app, exit);
  bezierbench::cli::add_verify(app, exit);
  bezierbench::cli::add_replay(app, exit);
  bezierbench::cli::add_choose(app, exit);
  bezierbench::cli::add_trials(app, exit);
  bezierbench::cli::add_doctor(app, exit);
  bezierbench::cli::add_curve(app, exit);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    const int code = app.exit(help, std::cout, std::cerr);
    return std::cout.flush() ? code : standard_output_failed();
  } catch (const CLI::ParseError& error) {
    return fail(Exit::usage, fmt::format("{}; see --help", complaint(app, error)));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return standard_output_failed();
  return static_cast<int>(exit);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    occupy_closed_streams();
    bezierbench::bundle::ignore_file_size_signal();
    const auto faults = bezierbench::cli::floating_point_faults();
    if (!faults.empty())
      return fail(Exit::environment,
                  fmt::format("this build or process does not compute in IEEE 754 double: {}; run `bezierbench doctor`",
                              fmt::join(faults, "; ")));
    return run_program(argc, argv);
  } catch (const Failure& failure) {
    return fail(failure.exit(), failure.what());
  } catch (const std::bad_alloc&) {
    return fail(Exit::environment, "out of memory; use fewer --jobs or a smaller suite");
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return standard_output_failed();
    return fail(Exit::input_output, error.what());
  }
}
