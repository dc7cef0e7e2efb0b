// SPDX-License-Identifier: MIT
#include "experiments/cli/check/commit_build.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>
#include <vector>

#include "experiments/cli/check/process.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {
namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::filesystem::path cache_folder() {
  for (const auto& [name, below] :
       {std::pair("XDG_CACHE_HOME", "bezierbench"), std::pair("HOME", ".cache/bezierbench")})
    if (const char* folder = std::getenv(name); folder != nullptr && *folder != '\0')
      return std::filesystem::path(folder) / below;
  throw Failure(Exit::environment, "neither XDG_CACHE_HOME nor HOME is set; set one, a commit is built below it");
}

/// One step of a build, whose output goes to a file.
void step(const Commit& commit, const std::vector<std::string>& words, const ProcessPlace& place) {
  if (const auto ended = run_process(words, place); ended.code != 0)
    throw Failure(Exit::environment, fmt::format("commit {}: {} failed with exit code {}; see {}", commit.id,
                                                 fmt::join(words, " "), ended.code, place.log.string()));
}

}  // namespace

std::optional<Commit> find_commit(const std::string& name) {
  if (name.empty() || name.starts_with('-')) return std::nullopt;
  const auto top = run_process({"git", "rev-parse", "--show-toplevel"}, {.silent = true});
  if (top.code != 0) return std::nullopt;
  const auto id = run_process({"git", "rev-parse", "--verify", "--quiet", name + "^{commit}"}, {.silent = true});
  if (id.code != 0) return std::nullopt;
  return Commit{first_line(id.output), first_line(top.output)};
}

std::filesystem::path folder_of(const Commit& commit) { return cache_folder() / "commits" / commit.id; }

std::filesystem::path log_of(const Commit& commit) { return folder_of(commit).parent_path() / (commit.id + ".log"); }

std::filesystem::path build(const Commit& commit) {
  const auto folder = folder_of(commit);
  const auto log = log_of(commit);
  std::error_code error;
  std::filesystem::create_directories(folder.parent_path(), error);
  if (error)
    throw Failure(Exit::input_output, fmt::format("{}: cannot be created: {}; set XDG_CACHE_HOME to another folder",
                                                  folder.parent_path().string(), error.message()));
  const std::string sources = folder.string();
  if (!std::filesystem::exists(folder))
    step(commit, {"git", "clone", "--quiet", "--no-checkout", commit.repository.string(), sources}, {.log = log});
  step(commit, {"git", "-C", sources, "checkout", "--quiet", "--detach", commit.id}, {.log = log});
  step(commit, {"cmake", "--preset", "release", "-DBEZIERBENCH_TESTS=OFF"}, {.folder = folder, .log = log});
  step(commit, {"cmake", "--build", "build/release", "--target", "bezierbench"}, {.folder = folder, .log = log});
  return folder / "build/release/bezierbench";
}

}  // namespace bezierbench::cli
