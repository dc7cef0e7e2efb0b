// SPDX-License-Identifier: MIT
#include "experiments/suite/text/toml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/failure.hpp"
#include "experiments/suite/goal.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::suite {

namespace {

/// Values of options are strings, which have no place in a file.
bool is_from_option(const toml::node& node) { return node.source().begin.line == 0; }

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

void fail(std::string_view name, const toml::source_position& at, std::string_view what) {
  if (at.line == 0) throw Failure(Exit::usage, fmt::format("{}: {}", name, what));
  throw Failure(Exit::usage, fmt::format("{}:{}:{}: {}", name, at.line, at.column, what));
}

void fail_type(const Source& source, const toml::node& node, std::string_view expected) {
  fail(source.name, node.source().begin, fmt::format("{} must be {}", source.key, expected));
}

void read(const Source& source, const toml::node& node, std::string& out) {
  const auto text = node.value_exact<std::string>();
  if (!text) fail_type(source, node, "a string");
  out = *text;
}

void read(const Source& source, const toml::node& node, std::int64_t& out) {
  std::optional<std::int64_t> value = node.value_exact<std::int64_t>();
  const auto text = node.value_exact<std::string>();
  if (is_from_option(node) && text) value = number::parse_integer(*text);
  if (!value)
    fail_type(source, node, is_from_option(node) ? "a whole number" : "a whole number such as 3, not 3.0 or \"3\"");
  out = *value;
}

void read(const Source& source, const toml::node& node, int& out) {
  std::int64_t value = 0;
  read(source, node, value);
  out = static_cast<int>(
      std::clamp<std::int64_t>(value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

void read(const Source& source, const toml::node& node, double& out) {
  std::optional<double> value = node.value_exact<double>();
  if (const auto integer = node.value_exact<std::int64_t>()) value = static_cast<double>(*integer);
  if (const auto text = node.value_exact<std::string>()) value = number::parse_number(*text);
  if (!value) fail_type(source, node, "a number that a double can hold, or such a number as a string");
  out = *value + 0.0;  // turns -0 into 0: inputs are keyed by the text of these values
}

void read(const Source& source, const toml::node& node, Interval& out) {
  const toml::array* ends = node.as_array();
  if (ends == nullptr || ends->size() != 2) fail_type(source, node, "an array of intervals [a, b]");
  read(source, *ends->get(0), out.min);
  read(source, *ends->get(1), out.max);
}

void read(const Source& source, const toml::node& node, const Kind*& out) {
  std::string word;
  read(source, node, word);
  const auto found = std::ranges::find(source.kinds, word, &Kind::id);
  if (found == source.kinds.end()) {
    std::vector<std::string> ids;
    for (const Kind* known : source.kinds) ids.emplace_back(known->id);
    fail(source.name, node.source().begin,
         fmt::format("unknown {} \"{}\"{}", source.key, echo(word), suggestion(word, ids)));
  }
  out = *found;
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

void read(std::string_view name, const toml::node& node, const Field& field, Study& out) {
  const Source from{name, field.key};
  const auto slot = field.slot(out);
  if (auto* const* texts = std::get_if<std::vector<std::string>*>(&slot);
      texts != nullptr && field.bare_if_single && node.is_string()) {
    (*texts)->resize(1);
    return read(from, node, (*texts)->front());
  }
  std::visit([&](auto* value) { read(from, node, *value); }, slot);
}

std::string to_text(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      text += fmt::format("\\u{:04x}", byte);
    } else {
      text += c;  // bytes of UTF-8 are kept
    }
  }
  return text + "\"";
}

std::string to_text(std::int64_t value) { return fmt::format("{}", value); }

std::string to_text(double value) {
  std::string text = number::decimal(value);
  // TOML reads a number without a point or an exponent as an integer, and its integers end at 2^63.
  const bool digits_only = text.find_first_not_of("-0123456789") == std::string::npos;
  if (digits_only && std::abs(value) >= 0x1p53) text += ".0";
  return text;
}

std::string to_text(const Kind* value) { return to_text(value->id); }

std::string to_text(const Interval& value) { return fmt::format("[{}, {}]", to_text(value.min), to_text(value.max)); }

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
