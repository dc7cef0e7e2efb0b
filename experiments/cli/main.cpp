// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/limits.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/cli/startup/welcome.hpp"
#include "experiments/cli/terminal/completion.hpp"
#include "experiments/cli/terminal/manual.hpp"
#include "experiments/number/floating_point.hpp"

namespace {

using bezierbench::Exit;
using bezierbench::Failure;

int fail(Exit exit, const std::string& line) {
  bezierbench::cli::say(line);
  return static_cast<int>(exit);
}

/// Opens descriptors in place of standard streams that are closed. Otherwise the next file that is opened, perhaps a
/// result, would get the number of a standard stream. Reading and writing fail on these descriptors, too.
void occupy_closed_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) == -1) open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int standard_output_failed() {
  return fail(Exit::input_output, "standard output: cannot be written; free space or choose another place");
}

/// Commands for the build and the shells, which no help shows.
void add_hidden(bezierbench::cli::Program& program, bezierbench::cli::Command& root) {
  namespace cli = bezierbench::cli;
  root.hidden_command("complete", [&program](const std::vector<std::string>& words) {
    for (const auto& line : cli::completions(program.tree(), words)) fmt::print("{}\n", line);
  });
  root.hidden_command("manual", [&program](const std::vector<std::string>& words) {
    if (words.size() != 1) throw Failure(Exit::usage, "manual: must be followed by a folder");
    cli::write_manual(program.tree(), words.front());
  });
}

int run_program(int argc, char** argv) {
  namespace cli = bezierbench::cli;
  if (argc == 1) {
    fmt::print("{}", cli::welcome());
    return std::fflush(stdout) == 0 ? static_cast<int>(Exit::fine) : standard_output_failed();
  }
  cli::Program program("bezierbench", "How wrong is each way of evaluating a Bezier curve, and how fast is it here?",
                       cli::version_line());
  Exit exit = Exit::fine;
  cli::Command root = program.command();
  root.needs_command();
  cli::add_run(root, exit);
  cli::add_merge(root, exit);
  cli::add_compare(root, exit);
  cli::add_list(root, exit);
  cli::add_verify(root, exit);
  cli::add_replay(root, exit);
  cli::add_choose(root, exit);
  cli::add_check(root, exit);
  cli::add_trials(root, exit);
  cli::add_doctor(root, exit);
  cli::add_curve(root, exit);
  add_hidden(program, root);
  program.run(argc, argv);
  if (!std::cout.flush() || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return standard_output_failed();
  return static_cast<int>(exit);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    occupy_closed_streams();
    bezierbench::cli::require_stack();
    bezierbench::cli::report_exhausted_memory();
    bezierbench::bundle::ignore_file_size_signal();
    const auto faults = bezierbench::number::floating_point_faults();
    if (!faults.empty())
      return fail(Exit::environment,
                  fmt::format("this build or process does not compute in IEEE 754 double: {}; run `bezierbench doctor`",
                              fmt::join(faults, "; ")));
    return run_program(argc, argv);
  } catch (const Failure& failure) {
    return fail(failure.exit(), failure.what());
  } catch (const std::bad_alloc&) {
    bezierbench::cli::end_without_memory();
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return standard_output_failed();
    // Failures, and errors of files and formats, have their own types; a plain runtime_error comes from a library.
    if (typeid(error) == typeid(std::runtime_error)) bezierbench::cli::end_without_resource(error.what());
    return fail(Exit::input_output, error.what());
  }
}
