// SPDX-License-Identifier: MIT
#include "experiments/suite/text/toml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/failure.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::suite {

namespace {

/// Values of options are strings, which have no place in a file.
bool is_from_option(const toml::node& node) { return node.source().begin.line == 0; }

}  // namespace

void fail(std::string_view name, const toml::source_position& at, std::string_view what) {
  if (at.line == 0) throw Failure(Exit::usage, "{}: {}", name, what);
  throw Failure(Exit::usage, "{}:{}:{}: {}", name, at.line, at.column, what);
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

}  // namespace bezierbench::suite
