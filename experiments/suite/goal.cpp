// SPDX-License-Identifier: MIT
#include "experiments/suite/goal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/suite/toml_value.hpp"

namespace bezierbench::suite {
namespace {

struct GoalKey {
  std::string_view key;
  void (*read)(const Source& source, const toml::node& node, Goal& out);
  std::string (*write)(const Goal& goal);
};

template <auto Member>
void read_member(const Source& source, const toml::node& node, Goal& out) {
  read(source, node, out.*Member);
}

/// The member as TOML; empty where it has its default.
template <auto Member>
std::string write_member(const Goal& goal) {
  return goal.*Member == Goal().*Member ? "" : to_text(goal.*Member);
}

void read_flag(const Source& source, const toml::node& node, Goal& out) {
  if (!node.is_boolean()) fail_type(source, node, "true or false");
  out.needs_additions_beside = node.value_or(false);
}

std::string write_flag(const Goal& goal) { return goal.needs_additions_beside ? "true" : ""; }

template <auto Member>
constexpr GoalKey goal_key(std::string_view key) {
  return {key, &read_member<Member>, &write_member<Member>};
}

constexpr std::array goal_keys{goal_key<&Goal::method>("method"),
                               goal_key<&Goal::share>("share"),
                               goal_key<&Goal::no_slower_than>("no_slower_than"),
                               goal_key<&Goal::scalar>("scalar"),
                               goal_key<&Goal::from_degree>("from_degree"),
                               goal_key<&Goal::to_degree>("to_degree"),
                               GoalKey{"needs_additions_beside", &read_flag, &write_flag}};

}  // namespace

std::string goal_problem(const Goal& goal, std::span<const std::string> methods) {
  for (const std::string& id : {goal.method, goal.no_slower_than})
    if (!id.empty() && std::ranges::find(methods, id) == methods.end())
      return fmt::format("unknown method \"{}\"{}", id, suggestion(id, methods));
  if (goal.method.empty()) return "a goal needs a method; add method = \"horner_fma\"";
  if ((goal.share == 0) == goal.no_slower_than.empty())
    return "a goal is a share of the peak or no_slower_than another method; give one of them";
  if (!(goal.share >= 0) || !std::isfinite(goal.share)) return "share must be above 0; 1 is the peak";
  if (goal.from_degree > goal.to_degree) return "from_degree is above to_degree; no row has such a degree";
  return {};
}

/// Reads a goal from an inline table.
void read(const Source& source, const toml::node& node, Goal& out) {
  const toml::table* table = node.as_table();
  if (table == nullptr) fail_type(source, node, "a table such as { method = \"horner_fma\", share = 0.85 }");
  for (const auto& [key, value] : *table) {
    const auto found = std::ranges::find(goal_keys, std::string_view(key.str()), &GoalKey::key);
    if (found == goal_keys.end()) {
      std::vector<std::string> allowed;
      for (const auto& one : goal_keys) allowed.emplace_back(one.key);
      fail(source.name, key.source().begin,
           fmt::format("unknown key \"{}\"{}", key.str(), suggestion(key.str(), allowed)));
    }
    found->read({source.name, found->key}, value, out);
  }
}

std::string to_text(const Goal& goal) {
  std::string text;
  for (const auto& key : goal_keys)
    if (const auto value = key.write(goal); !value.empty())
      text += fmt::format("{}{} = {}", text.empty() ? "{ " : ", ", key.key, value);
  return text + " }";
}

}  // namespace bezierbench::suite
