// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/suite_options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/cli/startup/curve_sets.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/nearest.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

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

/// Beside this program, or beside the bezierbench on the path, where this program is a user's own.
fs::path shipped_folder(const char* name) {
  std::error_code ignored;
  const auto installed = folder_of_program().parent_path() / "share/bezierbench" / name;
  std::vector<fs::path> folders{installed, link_of_build(name)};
  if (const auto bin = folder_on_path("bezierbench"))
    folders.insert(folders.end(), {bin->parent_path() / "share/bezierbench" / name, *bin / name});
  for (const auto& folder : folders)
    if (fs::is_directory(folder, ignored)) return folder;
  throw Failure(
      Exit::environment,
      fmt::format(
          "{}: is missing, and it comes with the program; install the program with cmake --install, put bezierbench on "
          "PATH, or name files",
          installed.string()));
}

}  // namespace

std::optional<fs::path> folder_on_path(std::string_view program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return folder;
  return std::nullopt;
}

fs::path suites_folder() { return shipped_folder("suites"); }

fs::path curves_folder() { return shipped_folder("curves"); }

fs::path answers_folder() { return shipped_folder("answers"); }

fs::path real_folder() { return shipped_folder("real"); }

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

fs::path report_script() {
  std::error_code error;
  const auto suites = fs::canonical(link_of_build("suites"), error);
  const auto script = suites.parent_path().parent_path() / "scripts/report";
  return !error && fs::exists(script, error) ? script : shipped_folder("scripts") / "report";
}

namespace {

/// The number in an option, from 0 on. CLI11 would turn a number beyond the range of the type into the largest one of the
/// type. Throws Failure(Exit::usage).
std::int64_t whole_number(std::string_view option, const std::string& text) {
  const auto number = number::parse_integer(text);
  if (!number || *number < 0)
    throw Failure(Exit::usage, fmt::format("{} {}: must be a whole number from 0 to 2^63-1", option, text));
  return *number;
}

}  // namespace

void SuiteOptions::add_suites(Command& command) {
  command.option("SUITE", words_, "id of a shipped suite, or a file: a word with / or ending in .toml")
      .required()
      .takes(suite_value, shipped_suites);
}

void SuiteOptions::add_changes(Command& command) {
  command.option("--seed", seed_, "seed; default: that of the suite");
  command.option("--trials", trials_, "trials per cell and replicate").takes("N");
  command
      .option("--set", overrides_.set,
              "set an axis or key of every study, which each must have; an interval is written 0:0.2")
      .takes("KEY=V1,V2", known_settings);
  command.option("--only", overrides_.only, "run only studies whose id matches this pattern").takes("GLOB");
}

void SuiteOptions::add_curves(Command& command) {
  command
      .option("--curves", curves_,
              "curve files, or ids of shipped curve sets, whose curves are the inputs of every study that takes curves")
      .takes("FILE", shipped_curves);
}

void SuiteOptions::add_no_timing(Command& command) {
  command.flag("--no-timing", overrides_.no_timing, "skip timing studies, with --counts only their times");
}

void SuiteOptions::add_counts(Command& command) {
  command.flag("--counts", overrides_.counts,
               "count the instructions of the timed methods with Valgrind, into cost.csv");
}

std::vector<std::filesystem::path> SuiteOptions::files() const {
  std::vector<std::filesystem::path> files;
  for (const auto& word : words_) files.push_back(suite_file(word));
  return files;
}

std::vector<suite::Suite> SuiteOptions::read(const suite::Vocabulary& known) const {
  auto overrides = overrides_;
  if (seed_) overrides.seed = static_cast<std::uint64_t>(whole_number("--seed", *seed_));
  if (trials_) overrides.trials = whole_number("--trials", *trials_);
  std::vector<suite::Suite> suites;
  for (const auto& file : files()) {
    for (auto& one : suite::read_suites(file, known)) suites.push_back(std::move(one));
    suite::check_unique_ids(suites, file.string());
  }
  if (!curves_.empty()) take_curves(suites, curves_);
  suite::apply(overrides, suites, known);
  if (!curves_.empty())
    for (const auto& one : suites)
      for (const auto& study : one.studies)
        if (const auto fault = suite::validate(study, known)) suite::refuse(study, *fault);
  load_curves(suites);
  if (!curves_.empty()) drop_without_curves(suites);
  return suites;
}

}  // namespace bezierbench::cli
