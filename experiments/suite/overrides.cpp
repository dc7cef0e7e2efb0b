// SPDX-License-Identifier: MIT
#include "experiments/suite/overrides.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cstddef>
#include <string_view>
#include <utility>

#include "experiments/echo.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/fields.hpp"
#include "experiments/suite/nearest.hpp"
#include "experiments/suite/pattern.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::suite {
namespace {

/// One option that changes a field of studies.
struct Setting {
  std::string option;  ///< as given, for messages
  const Field* field;
  toml::array values;
};

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// The values as the strings that a file may hold as well, so that one reader reads both.
toml::array values_of(std::string_view key, std::string_view text) {
  toml::array values;
  for (const std::string_view value : split(text, ',')) {
    if (key != "t_interval") {
      values.push_back(std::string(value));
      continue;
    }
    toml::array ends;
    for (const std::string_view end : split(value, ':')) ends.push_back(std::string(end));
    values.push_back(std::move(ends));
  }
  return values;
}

Setting parse_set(const std::string& text) {
  std::string option = "--set " + echo(text);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw Failure(Exit::usage, option + ": write it as axis=v1,v2");
  const std::string key = text.substr(0, equals);
  const Field* field = find_field(key);
  if (field == nullptr || !field->settable) {
    std::vector<std::string> keys;
    for (const Field& known : study_fields()) {
      if (known.settable) keys.emplace_back(known.key);
    }
    throw Failure(Exit::usage, fmt::format("{}: unknown axis \"{}\"{}", option, echo(key), suggestion(key, keys)));
  }
  if (equals + 1 == text.size()) throw Failure(Exit::usage, option + ": no value; write it as axis=v1,v2");
  return {std::move(option), field, values_of(key, std::string_view(text).substr(equals + 1))};
}

void set(const Setting& setting, Study& study) {
  const std::string_view key = setting.field->key;
  const bool single = setting.field->single;
  if (single && setting.values.size() != 1)
    throw Failure(Exit::usage, fmt::format("{}: takes one value; write {}=N", setting.option, key));
  const toml::node& node = single ? *setting.values.get(0) : static_cast<const toml::node&>(setting.values);
  setting.field->read(setting.option, key, node, study);
}

void keep_chosen(const Overrides& overrides, std::vector<Suite>& suites) {
  if (overrides.only == "")
    throw Failure(Exit::usage, overrides.only_option + ": is empty; name a study, or leave the option out");
  std::vector<std::string> ids;
  bool found = false;
  for (Suite& suite : suites) {
    std::erase_if(suite.studies, [&](const Study& study) {
      ids.push_back(study.id);
      const bool chosen = !overrides.only || matches(*overrides.only, study.id);
      found = found || chosen;
      return !chosen || (overrides.no_timing && is_timed(study.kind));
    });
  }
  if (!found) {
    throw Failure(Exit::usage, fmt::format("{} {}: no study matches{}", overrides.only_option, echo(*overrides.only),
                                           suggestion(*overrides.only, ids)));
  }
  std::erase_if(suites, [](const Suite& suite) { return suite.studies.empty(); });
  if (suites.empty()) throw Failure(Exit::usage, "--no-timing: only timing studies were chosen; choose others");
}

/// The option to blame for `problem`: the one that set the field, or the field that it does not fit.
std::string blamed(const Fault& problem, const std::vector<Setting>& settings) {
  for (const std::string_view key : {problem.key, problem.other_key}) {
    for (const Setting& setting : settings) {
      if (setting.field->key == key) return setting.option;
    }
  }
  return settings.front().option;  // nothing else changed the study
}

}  // namespace

void apply(const Overrides& overrides, std::vector<Suite>& suites, const Vocabulary& known) {
  std::vector<Setting> settings;
  if (overrides.trials) {
    const std::string trials = fmt::format("{}", *overrides.trials);
    settings.push_back({"--trials " + trials, find_field("trials"), values_of("trials", trials)});
  }
  for (const std::string& text : overrides.set) {
    Setting setting = parse_set(text);
    for (const Setting& other : settings) {
      if (other.field != setting.field) continue;
      throw Failure(Exit::usage, fmt::format("{}: {} sets this too; keep one of them", setting.option, other.option));
    }
    settings.push_back(std::move(setting));
  }
  if (overrides.seed) {
    if (const std::string what = seed_problem(*overrides.seed); !what.empty()) {
      throw Failure(Exit::usage, fmt::format("--seed {}: {}", *overrides.seed, what));
    }
  }

  std::vector<Suite> changed = suites;
  keep_chosen(overrides, changed);
  for (Suite& suite : changed) {
    if (overrides.seed) suite.seed = *overrides.seed;
    for (Study& study : suite.studies) {
      for (const Setting& setting : settings) {
        if (setting.field->key != "modes" || study.kind == Kind::timing) set(setting, study);
      }
      const auto problem = settings.empty() ? std::nullopt : validate(study, known);
      if (!problem) continue;
      throw Failure(Exit::usage,
                    fmt::format("{}: study \"{}\": {}", blamed(*problem, settings), study.id, problem->what));
    }
  }
  suites = std::move(changed);
}

}  // namespace bezierbench::suite
