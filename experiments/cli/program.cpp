// SPDX-License-Identifier: MIT
#include "experiments/cli/program.hpp"

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
#include "experiments/run/interruption.hpp"

namespace bezierbench::cli {
namespace {

int fail(Exit exit, const std::string& line) {
  say(line);
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
void add_hidden(Program& program, Command& root) {
  root.hidden_command("complete", [&program](const std::vector<std::string>& words) {
    for (const auto& line : completions(program.tree(), words)) fmt::print("{}\n", line);
  });
  root.hidden_command("manual", [&program](const std::vector<std::string>& words) {
    if (words.size() != 1) throw Failure(Exit::usage, "manual: must be followed by a folder");
    write_manual(program.tree(), words.front());
  });
}

int run_program(int argc, char** argv, std::span<const outside::OwnMethod> own) {
  if (argc == 1) {
    fmt::print("{}", welcome());
    return std::fflush(stdout) == 0 ? static_cast<int>(Exit::fine) : standard_output_failed();
  }
  Program program("bezierbench", "How wrong is each way of evaluating a Bezier curve, and how fast is it here?",
                  version_line());
  Exit exit = Exit::fine;
  Command root = program.command();
  root.needs_command();
  add_run(root, exit, own);
  add_merge(root, exit);
  add_compare(root, exit);
  add_list(root, exit, own);
  add_verify(root, exit);
  add_replay(root, exit, own);
  add_choose(root, exit);
  add_check(root, exit);
  add_trials(root, exit);
  add_doctor(root, exit);
  add_inputs(root, exit);
  add_judge(root, exit);
  add_curve(root, exit);
  add_hidden(program, root);
  program.run(argc, argv);
  if (!std::cout.flush() || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return standard_output_failed();
  return static_cast<int>(exit);
}

}  // namespace

int main(int argc, char** argv, std::span<const outside::OwnMethod> own) {
  try {
    occupy_closed_streams();
    require_stack();
    require_memory();
    report_exhausted_memory();
    bundle::ignore_file_size_signal();
    run::watch_for_interruption();
    const auto faults = number::floating_point_faults();
    if (!faults.empty())
      return fail(Exit::environment,
                  fmt::format("this build or process does not compute in IEEE 754 double: {}; run `bezierbench doctor`",
                              fmt::join(faults, "; ")));
    return run_program(argc, argv, own);
  } catch (const Failure& failure) {
    return fail(failure.exit(), failure.what());
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return standard_output_failed();
    // Failures, and errors of files and formats, have their own types; a plain runtime_error comes from a library.
    if (typeid(error) == typeid(std::runtime_error)) end_without_resource(error.what());
    return fail(Exit::input_output, error.what());
  }
}

}  // namespace bezierbench::cli
