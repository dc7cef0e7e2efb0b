// SPDX-License-Identifier: MIT
#include "experiments/suite/goal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/suite/text/toml_value.hpp"

namespace bezierbench::suite {
namespace {

void read_value(const Source& source, const toml::node& node, bool& out) {
  if (!node.is_boolean()) fail_type(source, node, "true or false");
  out = node.value_or(false);
}
void read_value(const Source& source, const toml::node& node, auto& out) { read(source, node, out); }

std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(const auto& value) { return to_text(value); }

std::vector<std::string> goal_keys() {
  std::vector<std::string> all;
  each_goal_key([&](const char* key, auto, auto) { all.emplace_back(key); });
  return all;
}

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
    const std::string_view written = key.str();
    bool is_known = false;
    each_goal_key([&, &entry = value](std::string_view known, auto /*meaning*/, auto member) {
      if (known != written) return;
      is_known = true;
      read_value({source.name, known}, entry, out.*member);
    });
    if (!is_known)
      fail(source.name, key.source().begin,
           fmt::format("unknown key \"{}\"{}", echo(written), suggestion(written, goal_keys())));
  }
}

/// Keys that have their defaults are left out.
std::string to_text(const Goal& goal) {
  std::string text;
  each_goal_key([&](std::string_view key, auto /*meaning*/, auto member) {
    if (goal.*member == Goal().*member) return;
    text += fmt::format("{}{} = {}", text.empty() ? "{ " : ", ", key, text_of(goal.*member));
  });
  return text + " }";
}

}  // namespace bezierbench::suite
