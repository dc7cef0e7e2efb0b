// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/suites_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "experiments/failure.hpp"
#include "experiments/suite/nearest.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".toml";

fs::path folder_of_program() {
  std::error_code error;
  const auto program = fs::read_symlink("/proc/self/exe", error);
  if (error)
    throw Failure(Exit::environment,
                  fmt::format("/proc/self/exe: cannot be read ({}); mount /proc, or name suites by their files",
                              error.message()));
  return program.parent_path();
}

/// The link to the folder `name` that CMake makes in the build folder.
fs::path link_of_build(const char* name) { return folder_of_program() / name; }

fs::path shipped_folder(const char* name) {
  std::error_code ignored;
  const auto installed = folder_of_program().parent_path() / "share/bezierbench" / name;
  for (const auto& folder : {installed, link_of_build(name)})
    if (fs::is_directory(folder, ignored)) return folder;
  throw Failure(Exit::environment,
                fmt::format("{}: the shipped {} are missing; install the program with cmake --install, or name files",
                            installed.string(), name));
}

}  // namespace

fs::path suites_folder() { return shipped_folder("suites"); }

fs::path curves_folder() { return shipped_folder("curves"); }

fs::path answers_folder() { return shipped_folder("answers"); }

std::vector<std::string> shipped_suites() {
  std::vector<std::string> ids;
  std::error_code error;
  const auto folder = suites_folder();
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == extension) ids.push_back(entry->path().stem().string());
  if (error)
    throw Failure(Exit::environment,
                  fmt::format("{}: cannot be read ({}); name suites by their files", folder.string(), error.message()));
  std::ranges::sort(ids);
  return ids;
}

fs::path suite_file(const std::string& word) {
  if (word.find('/') != std::string::npos || word.ends_with(extension)) return word;
  const auto ids = shipped_suites();
  if (std::ranges::find(ids, word) == ids.end())
    throw Failure(Exit::usage, fmt::format("{}: unknown suite{}; for a file, write ./{}", echo(word),
                                           suite::suggestion(word, ids), echo(word)));
  return suites_folder() / (word + extension);
}

fs::path script_of_source(const std::string& name) {
  std::error_code error;
  const auto suites = fs::canonical(link_of_build("suites"), error);
  const auto script = suites.parent_path().parent_path() / "scripts" / name;
  return !error && fs::exists(script, error) ? fs::proximate(script, error) : fs::path();
}

}  // namespace bezierbench::cli
