// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "core/api/floating_point_faults.hpp"
#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/external/harness.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

/// The end of the program's help and manual page, for which help2man knows the headings; the examples follow. docs/terminal.md has the same codes, which a test compares.
constexpr std::string_view exit_codes =
    "Exit codes:\n"
    "  0    success\n"
    "  1    a finding: a gate failed, bytes differ, a bound was violated\n"
    "  2    wrong usage or configuration\n"
    "  3    this machine or build is unfit, or memory is exhausted\n"
    "  4    input or output failed: no space, no permission, a malformed file\n"
    "  130  interrupted; the same command continues the run\n"
    "\n"
    "Environment:\n"
    "  COLUMNS   the width of help and tables, if it is not that of the terminal\n"
    "  NO_COLOR  if not empty, no colours are used\n"
    "\n"
    "Examples:\n";

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> examples{{
    {"bezierbench list suites", "suites and their cost"},
    {"bezierbench run report --out b", "repeat the report"},
    {"bezierbench choose b --degree 4 --tolerance 10 --unit u", "rank its methods"},
    {"bezierbench curve eval --curve c.csv --t 0.5", "one curve's errors"},
    {"bezierbench --help", "list all commands"},
}};

/// The examples, one line each, two on a terminal that is narrower than these lines.
std::string examples_text(std::size_t before) {
  constexpr std::size_t column = 57;
  constexpr std::size_t usual = 80;
  std::string text;
  for (const auto& [command, meaning] : examples)
    text += std::string(before, ' ') + styled(STDOUT_FILENO, fmt::emphasis::bold, command) +
            (output_width() < usual ? "\n    " : std::string(column - command.size(), ' ')) + std::string(meaning) +
            '\n';
  return text;
}

int fail(Exit exit, const std::string& line) {
  say(line);
  return static_cast<int>(exit);
}

int standard_output_failed() {
  return fail(Exit::input_output, "standard output: cannot be written; free space or choose another place");
}

int run_program(int argc, char** argv, std::span<const external::OwnMethod> own) {
  if (argc == 1) {
    fmt::print("{}", examples_text(0));
    return std::fflush(stdout) == 0 ? static_cast<int>(Exit::fine) : standard_output_failed();
  }
  Program program("bezierbench",
                  "Compares ways of evaluating Bezier curves, and companion problems, with an exact reference.",
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
  add_report(root);
  add_choose(root, exit);
  add_check(root, exit, own);
  add_trials(root, exit);
  add_doctor(root, exit);
  add_inputs(root, exit);
  add_judge(root, exit);
  add_curve(root, exit);
  add_curves(root, exit);
  root.footer(std::string(exit_codes) + examples_text(2));  // commands that are added later would inherit it
  program.run(argc, argv);
  if (!std::cout.flush() || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return standard_output_failed();
  return static_cast<int>(exit);
}

}  // namespace
}  // namespace bezierbench::cli

namespace bezierbench::harness {

int run(int argc, char** argv, std::span<const external::OwnMethod> own) {
  using namespace cli;
  try {
    bundle::ignore_file_size_signal();
    run::watch_for_interruption();
    const auto faults = floating_point_faults();
    if (!faults.empty())
      return fail(Exit::environment,
                  fmt::format("this build or process does not compute in IEEE 754 double: {}; run `bezierbench doctor`",
                              fmt::join(faults, "; ")));
    return run_program(argc, argv, own);
  } catch (const Failure& failure) {
    return fail(failure.exit(), failure.what());
  } catch (const std::bad_alloc&) {
    return fail(Exit::environment, "memory is exhausted; raise its limit (ulimit -v), or use fewer --jobs");
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return standard_output_failed();
    return fail(Exit::input_output, error.what());
  }
}

}  // namespace bezierbench::harness
