// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/suite_options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/failure.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/curves/csv.hpp"
#include "reference/curves/read.hpp"
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
    throw Failure(Exit::environment, "/proc/self/exe: cannot be read ({}); mount /proc, or name suites by their files",
                  error.message());
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
  throw Failure(Exit::environment,
                "{}: is missing, and it comes with the program; install the program with cmake --install, put "
                "bezierbench on PATH, or name files",
                installed.string());
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
    throw Failure(Exit::environment, "{}: cannot be read ({}); name suites by their files", folder.string(),
                  error.message());
  std::ranges::sort(ids);
  return ids;
}

fs::path suite_file(const std::string& word) {
  if (word.find('/') != std::string::npos || word.ends_with(extension)) return word;
  const auto ids = shipped_suites();
  if (std::ranges::find(ids, word) == ids.end())
    throw Failure(Exit::usage, "{}: unknown suite{}; for a file, write ./{}", echo(word), suite::suggestion(word, ids),
                  echo(word));
  return suites_folder() / (word + extension);
}

fs::path report_script() {
  std::error_code error;
  const auto suites = fs::canonical(link_of_build("suites"), error);
  const auto script = suites.parent_path().parent_path() / "scripts/report";
  return !error && fs::exists(script, error) ? script : shipped_folder("scripts") / "report";
}

namespace {

/// The number in an option, from 0 on. CLI11 would turn a number beyond the range of the type into the largest one of
/// the type. Throws Failure(Exit::usage).
std::int64_t whole_number(std::string_view option, const std::string& text) {
  const auto number = number::parse_integer(text);
  if (!number || *number < 0)
    throw Failure(Exit::usage, "{} {}: must be a whole number from 0 to 2^63-1", option, text);
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

namespace {

namespace fs = std::filesystem;

/// What an entry of `curves` means.
struct Entry {
  fs::path file;
  std::string id;
  std::string glob;  ///< of the ids of curves; empty: all
  bool is_shipped = false;
};

bool names_file(const std::string& word) {
  return word.find('/') != std::string::npos || curves::has_known_extension(word);
}

/// An entry of `curves` as the set and the glob behind its last `#`. A file in `folder` of the whole name comes first.
std::pair<std::string, std::string> set_and_glob(const fs::path& folder, const std::string& text) {
  const auto mark = text.rfind('#');
  if (mark == std::string::npos || fs::exists(folder / text)) return {text, {}};
  return {text.substr(0, mark), text.substr(mark + 1)};
}

/// The file name of a copy of the set, without what begins and ends it.
std::string part_of_name(std::string id) {
  for (char& c : id)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-' && c != '.') c = '_';
  return id;
}

/// The id of a set of this file, which a copy of it in a bundle keeps.
std::string id_of(const fs::path& file) {
  auto id = file.stem().string();
  if (id.starts_with(bundle::curves_prefix)) id.erase(0, std::string_view(bundle::curves_prefix).size());
  return part_of_name(id);
}

Entry entry_of(const suite::Study& study, std::size_t number) {
  const fs::path folder = fs::path(study.places.file).parent_path();
  const auto [word, glob] = set_and_glob(folder, study.curves[number]);
  Entry entry;
  entry.glob = glob;
  if (names_file(word)) {
    entry.file = folder / word;
    entry.id = id_of(entry.file);
    return entry;
  }
  const auto ids = shipped_curves();
  if (std::ranges::find(ids, word) == ids.end())
    suite::refuse(
        study,
        {"curves", number, {}, fmt::format("unknown curve set \"{}\"{}", echo(word), suite::suggestion(word, ids))});
  entry.file = curves_folder() / (word + ".csv");
  entry.id = word;
  entry.is_shipped = true;
  return entry;
}

curves::CurveSet matching(const curves::CurveSet& all, const std::string& glob) {
  curves::CurveSet some;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (suite::matches(glob, all.id(k))) some.add(all.id(k), all[k], all.begins_path(k), all.parameters(k));
  return some;
}

std::shared_ptr<const sample::LoadedSet> loaded(const suite::Study& study, std::size_t number, const Entry& entry) {
  auto set = std::make_shared<sample::LoadedSet>();
  set->id = entry.glob.empty() ? entry.id : fmt::format("{}#{}", entry.id, entry.glob);
  if (!entry.is_shipped) set->id = part_of_name(set->id);
  set->is_shipped = entry.is_shipped;
  set->curves = read_set(entry.file.string(), Form::bernstein).set;
  if (!entry.glob.empty()) set->curves = matching(set->curves, entry.glob);
  if (set->curves.empty())
    suite::refuse(study, {"curves",
                          number,
                          {},
                          fmt::format("{} has no such curve; see `bezierbench curves {}`", echo(study.curves[number]),
                                      echo(entry.file.string()))});
  set->sha256 = bundle::sha256_hex(set->curves.canonical_bytes());
  return set;
}

template <class Visit>
void each_study_of_sets(std::vector<suite::Suite>& suites, const Visit& visit) {
  for (auto& one : suites)
    for (auto& study : one.studies)
      if (suite::has_sets(study)) visit(study);
}

}  // namespace

std::shared_ptr<const sample::LoadedSet> set_of(std::string_view id, curves::CurveSet given) {
  auto set = std::make_shared<sample::LoadedSet>();
  set->id = part_of_name(std::string(id));
  set->curves = std::move(given);
  set->sha256 = bundle::sha256_hex(set->curves.canonical_bytes());
  return set;
}

std::vector<std::string> shipped_curves() {
  std::vector<std::string> ids;
  for (const auto& entry : fs::directory_iterator(curves_folder()))
    if (entry.path().extension() == ".csv") ids.push_back(entry.path().stem().string());
  std::ranges::sort(ids);
  return ids;
}

void load_curves(std::vector<suite::Suite>& suites) {
  std::map<std::string, std::shared_ptr<const sample::LoadedSet>> read;  // by file and glob
  each_study_of_sets(suites, [&](suite::Study& study) {
    const auto stated = std::exchange(study.curves_sha256, {});
    study.sets.clear();
    for (std::size_t k = 0; k < study.curves.size(); ++k) {
      const Entry entry = entry_of(study, k);
      auto& set = read[fmt::format("{}#{}", entry.file.string(), entry.glob)];
      if (!set) set = loaded(study, k, entry);
      if (!stated.empty() && stated[k] != set->sha256)
        suite::refuse(study, {"curves_sha256", k, "curves",
                              fmt::format("the numbers of {} have the SHA-256 {}, not {}; restore the set, or leave "
                                          "curves_sha256 out",
                                          echo(study.curves[k]), set->sha256, echo(stated[k]))});
      study.sets.push_back(set);
      study.curves_sha256.push_back(set->sha256);
    }
  });
}

std::vector<std::pair<std::string, std::string>> curves_beside(std::vector<suite::Suite>& suites) {
  std::map<std::string, std::shared_ptr<const sample::LoadedSet>> copied;  // by name
  each_study_of_sets(suites, [&](suite::Study& study) {
    for (std::size_t k = 0; k < study.curves.size(); ++k) {
      const auto& set = study.sets[k];
      if (set->is_shipped) continue;
      const auto name = fmt::format("{}{}.csv", bundle::curves_prefix, set->id);
      const auto [at, is_new] = copied.emplace(name, set);
      if (!is_new && at->second->sha256 != set->sha256)
        suite::refuse(study,
                      {"curves", k, {}, fmt::format("two sets have the id {}; rename one of the files", set->id)});
      study.curves[k] = name;
    }
  });
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [name, set] : copied) files.emplace_back(name, curves::to_csv(set->curves));
  return files;
}

void take_curves(std::vector<suite::Suite>& suites, const std::vector<std::string>& files) {
  for (auto& one : suites) {
    std::erase_if(one.studies,
                  [](const auto& study) { return studies::kind_of_inputs(study).inputs.sets == suite::SetUse::none; });
    for (auto& study : one.studies) {
      for (const auto* field : suite::fields_of(suite::kind_of(study)))
        if (field->curves == suite::Curves::drawn) study.places.keys.erase(std::string(field->key));
      study.places.keys["curve"];  // only curves of this form, stated or not
      study.curves.clear();
      for (const auto& file : files)
        study.curves.push_back(names_file(set_and_glob({}, file).first) ? fs::absolute(file).string() : file);
      study.curves_sha256.clear();
      study.degree.clear();
      study.dimension.clear();
      study.places.options["curves"] = fmt::format("--curves {}", echo(files.front()));
    }
  }
  std::erase_if(suites, [](const auto& one) { return one.studies.empty(); });
  if (suites.empty())
    throw Failure(Exit::usage, "--curves {}: no study of the suite takes curves; choose another suite",
                  echo(files.front()));
}

void drop_without_curves(std::vector<suite::Suite>& suites) {
  std::string last;
  for (auto& one : suites)
    std::erase_if(one.studies, [&](const auto& study) {
      last = study.curves.front();
      return suite::kind_of(study).inputs.sets != suite::SetUse::required && !sample::has_inputs(study);
    });
  std::erase_if(suites, [](const auto& one) { return one.studies.empty(); });
  if (suites.empty())
    throw Failure(
        Exit::usage,
        "--curves {}: no study of the suite takes curves of these forms and degrees; see `bezierbench curves`",
        echo(last));
}

}  // namespace bezierbench::cli
