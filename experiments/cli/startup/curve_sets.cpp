// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/curve_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/failure.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/nearest.hpp"
#include "experiments/suite/pattern.hpp"
#include "reference/curves/csv.hpp"
#include "reference/curves/read.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
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
    throw Failure(Exit::usage, fmt::format("--curves {}: no study of the suite takes curves; choose another suite",
                                           echo(files.front())));
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
    throw Failure(Exit::usage,
                  fmt::format("--curves {}: no study of the suite takes curves of these forms and degrees; see "
                              "`bezierbench curves`",
                              echo(last)));
}

}  // namespace bezierbench::cli
