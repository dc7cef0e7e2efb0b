// SPDX-License-Identifier: MIT
#include "experiments/cli/check/against.hpp"

#include <fmt/format.h>

#include <system_error>

#include "experiments/cli/check/commit_build.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/echo.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {

Against find_against(const std::string& word, bool quiet) {
  std::error_code error;
  if (std::filesystem::is_directory(word, error)) return {Against::Kind::bundle, word, word};
  if (std::filesystem::is_regular_file(word, error))
    return {Against::Kind::program, word, std::filesystem::absolute(word)};
  const auto commit = find_commit(word);
  if (!commit)
    throw Failure(Exit::usage,
                  fmt::format("--against {}: is no file, no folder and no commit of a repository here; name "
                              "a program, a bundle or a commit",
                              echo(word)));
  constexpr std::size_t enough_digits = 12;
  if (!quiet)
    say(fmt::format("builds commit {} in {}, output in {}; the first time this may take an hour",
                    commit->id.substr(0, enough_digits), folder_of(*commit).string(), log_of(*commit).string()));
  return {Against::Kind::program, fmt::format("commit {}", commit->id.substr(0, enough_digits)), build(*commit)};
}

}  // namespace bezierbench::cli
