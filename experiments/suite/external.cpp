// SPDX-License-Identifier: MIT
#include "experiments/suite/external.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <set>

#include "experiments/suite/text/toml_value.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::size_t max_id_length = 64;

/// The keys that records of earlier versions do not have.
constexpr std::array<std::string_view, 2> later_keys{"scalars", "problems"};

/// The keys of an [[external]] table with their places in a record; `Method` is const to write, else to read.
template <class Method, class Visit>
void each_key(Method& method, Visit visit) {
  visit("id", method.id);
  visit("kind", method.kind);
  visit("label", method.label);
  visit("form", method.form);
  visit("min_degree", method.min_degree);
  visit("max_degree", method.max_degree);
  visit("scalars", method.scalars);
  visit("problems", method.problems);
  visit("source", method.source);
  visit("sha256", method.sha256);
}

ExternalMethod method_of(const toml::table& table, std::string_view file) {
  ExternalMethod method;
  std::set<std::string_view> known;
  each_key(method, [&](std::string_view key, auto& value) {
    known.insert(key);
    const toml::node* node = table.get(key);
    if (node != nullptr)
      read(Source{file, key}, *node, value);
    else if (std::ranges::count(later_keys, key) == 0)
      fail(file, table.source().begin, fmt::format("{} is missing; add it", key));
  });
  for (const auto& [key, node] : table)
    if (!known.contains(key.str()))
      fail(file, key.source().begin, fmt::format("unknown key \"{}\"; remove it", echo(key.str())));
  if (auto what = external_id_problem(method.id, method.kind); !what.empty())
    fail(file, table.get("id")->source().begin, what);
  if (method.min_degree < 0 || method.max_degree > max_degree || method.min_degree > method.max_degree)
    fail(file, table.get("min_degree")->source().begin, fmt::format("degrees must be from 0 to {}", max_degree));
  return method;
}

}  // namespace

bool is_external(std::string_view id) {
  return std::ranges::any_of(words<ExternalKind>, [&](const auto& one) {
    return id.starts_with(one.word) && id.substr(one.word.size()).starts_with('_');
  });
}

std::string external_id_problem(std::string_view id, ExternalKind kind) {
  const auto prefix = fmt::format("{}_", name(kind));
  const bool plain = id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
  if (id.starts_with(prefix) && id.size() > prefix.size() && id.size() <= max_id_length && plain) return {};
  return fmt::format("the id \"{}\" must be {} and lower-case letters, digits or _, at most {} characters", echo(id),
                     prefix, max_id_length);
}

std::string to_toml(std::span<const ExternalMethod> methods) {
  std::string text;
  for (const auto& method : methods) {
    text += "\n[[external]]\n";
    each_key(method,
             [&](std::string_view key, const auto& value) { text += fmt::format("{} = {}\n", key, to_text(value)); });
  }
  return text;
}

std::vector<ExternalMethod> parse_external(std::string_view text, std::string_view file_name) {
  std::vector<ExternalMethod> methods;
  try {
    const auto document = toml::parse(text);
    const toml::node* node = document.get("external");
    if (node == nullptr) return methods;
    const toml::array* tables = node->as_array();
    if (tables == nullptr)
      fail(file_name, node->source().begin, "external must be an array of tables; write [[external]]");
    for (const toml::node& table : *tables) {
      if (!table.is_table()) fail(file_name, table.source().begin, "external must be an array of tables");
      methods.push_back(method_of(*table.as_table(), file_name));
      for (std::size_t k = 0; k + 1 < methods.size(); ++k)
        if (methods[k].id == methods.back().id)
          fail(file_name, table.source().begin, "another external method has this id; remove one");
    }
  } catch (const toml::parse_error& error) {
    fail(file_name, error.source().begin, "not TOML; correct the syntax here");
  }
  return methods;
}

}  // namespace bezierbench::suite
