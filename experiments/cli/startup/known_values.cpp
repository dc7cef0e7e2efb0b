// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/known_values.hpp"

#include <algorithm>

#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::cli {
namespace {

template <class Wanted>
std::vector<std::string> ids_where(Wanted wanted) {
  std::vector<std::string> ids;
  for (const auto* info : every_method())
    if (wanted(*info) && std::ranges::find(ids, info->id) == ids.end()) ids.emplace_back(info->id);
  return ids;
}

/// The values that a key takes where they are words; empty where they are numbers or texts.
std::vector<std::string> words_of(std::string_view key) {
  const auto known = vocabulary();
  if (key == "methods") return known.methods;
  if (key == "scalar") return suite::all_words<suite::ScalarKind>();
  if (key == "modes") return suite::all_words<suite::Mode>();
  if (key == "curve") return suite::all_words<Form>();
  std::vector<std::string> generators;
  if (key == "generator")
    for (const auto& generator : known.generators) generators.push_back(generator.id);
  return generators;
}

}  // namespace

KnownValues methods_of(Problem problem) {
  return [problem] { return ids_where([problem](const MethodInfo& info) { return info.problem == problem; }); };
}

KnownValues all_methods() {
  return [] { return ids_where([](const MethodInfo& /*info*/) { return true; }); };
}

std::vector<std::string> known_settings() {
  std::vector<std::string> settings;
  std::vector<std::string_view> keys;
  for (const auto* kind : studies::kinds())
    for (const auto* field : suite::fields_of(*kind))
      if (field->settable && std::ranges::find(keys, field->key) == keys.end()) keys.push_back(field->key);
  for (const auto key : keys) {
    const auto values = words_of(key);
    if (values.empty()) settings.push_back(std::string(key) + '=');
    for (const auto& value : values) settings.push_back(std::string(key) + '=' + value);
  }
  return settings;
}

}  // namespace bezierbench::cli
