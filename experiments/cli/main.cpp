// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/floating_point.hpp"
#include "experiments/cli/vocabulary.hpp"

namespace {

using bezierbench::Exit;
using bezierbench::Failure;

/// Every failure is one line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

int fail(Exit exit, const std::string& line) {
  fmt::print(stderr, "bezierbench: {}\n", one_line(line));
  return static_cast<int>(exit);
}

int run_program(int argc, char** argv) {
  CLI::App app{"How wrong is each way of evaluating a Bezier curve, and how fast is it here?", "bezierbench"};
  app.require_subcommand(1);
  app.set_version_flag("--version", bezierbench::cli::version_line());
  Exit exit = Exit::fine;
  bezierbench::cli::add_run(app, exit);
  bezierbench::cli::add_list(app, exit);
  bezierbench::cli::add_verify(app, exit);
  bezierbench::cli::add_doctor(app, exit);
  bezierbench::cli::add_curve(app, exit);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(Exit::usage, fmt::format("{}; see --help", error.what()));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail(Exit::input_output, "standard output: cannot be written; free space or choose another place");
  return static_cast<int>(exit);
}

}  // namespace

int main(int argc, char** argv) {
  try {
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
    return fail(Exit::input_output, error.what());
  }
}
