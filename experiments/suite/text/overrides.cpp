// SPDX-License-Identifier: MIT
#include "experiments/suite/text/overrides.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "experiments/failure.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/toml_value.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::suite {
namespace {

/// One option that changes a key of studies.
struct Setting {
  std::string option;  ///< as given, for messages
  std::string key;
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

/// The values as strings, which the reader of files takes for numbers.
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

/// The settable keys of the kinds, each once.
std::vector<std::string> settable_keys(std::span<const Kind* const> kinds) {
  std::vector<std::string> keys;
  for (const Kind* kind : kinds)
    for (const Field* field : fields_of(*kind))
      if (field->settable && std::ranges::find(keys, field->key) == keys.end()) keys.emplace_back(field->key);
  return keys;
}

Setting parse_set(const std::string& text, const Vocabulary& known) {
  std::string option = "--set " + echo(text);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw Failure(Exit::usage, option + ": write it as axis=v1,v2");
  const std::string key = text.substr(0, equals);
  const auto keys = settable_keys(known.kinds);
  if (std::ranges::find(keys, key) == keys.end())
    throw Failure(Exit::usage, "{}: unknown axis \"{}\"{}", option, echo(key), suggestion(key, keys));
  if (equals + 1 == text.size()) throw Failure(Exit::usage, option + ": no value; write it as axis=v1,v2");
  return {std::move(option), key, values_of(key, std::string_view(text).substr(equals + 1))};
}

void set(const Setting& setting, Study& study, const Vocabulary& known) {
  const Kind& kind = kind_of(study);
  study.places.options[setting.key] = setting.option;
  const Field* field = find_field(kind, setting.key);
  if (field == nullptr)
    refuse(study, {setting.key,
                   Fault::key_itself,
                   {},
                   foreign_key_problem(kind, setting.key, known.kinds) + "; choose studies with --only"});
  const bool single = std::holds_alternative<std::int64_t*>(field->slot(study));
  if (single && setting.values.size() != 1)
    throw Failure(Exit::usage, "{}: takes one value; write {}=N", setting.option, setting.key);
  const toml::node& node = single ? *setting.values.get(0) : static_cast<const toml::node&>(setting.values);
  read(setting.option, node, *field, study);
}

void keep_chosen(const Overrides& overrides, std::vector<Suite>& suites) {
  if (overrides.only == "")
    throw Failure(Exit::usage, overrides.only_option + ": is empty; name a study, or leave the option out");
  std::vector<std::string> ids;
  bool found = false;
  for (Suite& suite : suites) {
    std::erase_if(suite.studies, [&](Study& study) {
      ids.push_back(study.id);
      const bool chosen = !overrides.only || matches(*overrides.only, study.id);
      found = found || chosen;
      const bool can_count = overrides.counts && find_field(kind_of(study), "counts") != nullptr;
      if (can_count) study.counts = overrides.no_timing ? Counting::only : Counting::beside_times;
      return !chosen || (overrides.no_timing && !can_count && kind_of(study).timed);
    });
  }
  if (!found)
    throw Failure(Exit::usage, "{} {}: no study matches{}", overrides.only_option, echo(*overrides.only),
                  suggestion(*overrides.only, ids));
  std::erase_if(suites, [](const Suite& suite) { return suite.studies.empty(); });
  if (suites.empty()) throw Failure(Exit::usage, "--no-timing: only timing studies were chosen; choose others");
}

/// Throws for a fault that the settings introduced. A fault may be in a key that no setting changed, if that key and
/// changed ones do not fit; it is then reported at the first setting.
[[noreturn]] void refuse_setting(const Study& study, const Setting& first, Fault fault) {
  const auto is_set = [&](std::string_view key) { return study.places.options.contains(std::string(key)); };
  if (!is_set(fault.key) && !is_set(fault.other_key)) fault.other_key = first.key;
  refuse(study, fault);
}

}  // namespace

void apply(const Overrides& overrides, std::vector<Suite>& suites, const Vocabulary& known) {
  std::vector<Setting> settings;
  if (overrides.trials) {
    const std::string trials = fmt::format("{}", *overrides.trials);
    settings.push_back({"--trials " + trials, "trials", values_of("trials", trials)});
  }
  for (const std::string& text : overrides.set) {
    Setting setting = parse_set(text, known);
    for (const Setting& other : settings) {
      if (other.key != setting.key) continue;
      throw Failure(Exit::usage, "{}: {} sets this too; keep one of them", setting.option, other.option);
    }
    settings.push_back(std::move(setting));
  }
  if (overrides.seed)
    if (const std::string what = seed_problem(*overrides.seed); !what.empty())
      throw Failure(Exit::usage, "--seed {}: {}", *overrides.seed, what);

  std::vector<Suite> changed = suites;
  keep_chosen(overrides, changed);
  for (Suite& suite : changed) {
    if (overrides.seed) suite.seed = *overrides.seed;
    for (Study& study : suite.studies) {
      for (const Setting& setting : settings) set(setting, study, known);
      if (settings.empty()) continue;
      if (auto fault = validate(study, known)) refuse_setting(study, settings.front(), std::move(*fault));
    }
  }
  suites = std::move(changed);
}

}  // namespace bezierbench::suite
