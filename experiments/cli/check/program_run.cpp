// SPDX-License-Identifier: MIT
#include "experiments/cli/check/program_run.hpp"

#include <fmt/format.h>

#include "experiments/cli/check/process.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {

void run_suite(const std::filesystem::path& program, const std::filesystem::path& suite,
               const std::filesystem::path& out) {
  const auto ended = run_process({program.string(), "run", suite.string(), "--out", out.string(), "--quiet"});
  if (ended.code == cannot_be_started)
    throw Failure(Exit::usage,
                  fmt::format("{}: cannot be started; name a bezierbench, a bundle or a commit", program.string()));
  if (ended.code != static_cast<int>(Exit::fine) && ended.code != static_cast<int>(Exit::finding))
    throw Failure(Exit::usage, fmt::format("{}: its `run` of these cells ended with exit code {}; name a bezierbench "
                                           "that has the method",
                                           program.string(), ended.code));
}

}  // namespace bezierbench::cli
