// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/schema.hpp"

#include <fmt/format.h>
#include <regex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "experiments/bundle/json_object.hpp"
#include "experiments/failure.hpp"
#include "schemas.hpp"

namespace bezierbench::bundle {

namespace {

class Pattern {
 public:
  explicit Pattern(const std::string& text) {
    if (regcomp(&compiled_, text.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
      throw std::invalid_argument("no regular expression: " + text);
  }
  ~Pattern() { regfree(&compiled_); }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  [[nodiscard]] bool matches(const std::string& text) const {
    return text.find('\0') == std::string::npos && regexec(&compiled_, text.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

}  // namespace

bool matches(const std::string& pattern, const std::string& text) {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Pattern>> patterns;
  const std::lock_guard lock(mutex);
  auto& compiled = patterns[pattern];
  if (!compiled) compiled = std::make_unique<Pattern>(pattern);
  return compiled->matches(text);
}

namespace {

using Json = Schema::Json;
using Fault = std::optional<std::string>;

/// One keyword of a schema, applied to one value.
struct Question {
  const Schema& schema;
  const Json& part;  ///< the schema with the keyword
  const Json& rule;  ///< the value of the keyword
  const Json& value;

  [[nodiscard]] const Json* beside(const char* keyword) const {
    const auto found = part.find(keyword);
    return found == part.end() ? nullptr : &*found;
  }
};

Fault where(bool holds, std::string_view otherwise) { return holds ? Fault() : Fault(otherwise); }

/// The beginning of a value as JSON, for messages.
std::string brief(const Json& value) {
  constexpr std::size_t most = 60;
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

Fault below(std::string_view name, Fault inner) {
  if (!inner) return inner;
  const bool goes_on = inner->find(' ') != 0;
  return fmt::format("{}{}{}", name, goes_on ? "." : "", *inner);
}

bool is_of(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "number") return value.is_number();
  if (type == "integer")
    return value.is_number_integer() ||
           (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
  throw std::invalid_argument("no type of JSON: " + type);
}

Fault type(const Question& q) {
  const bool several = q.rule.is_array();
  const bool holds =
      several ? std::ranges::any_of(q.rule, [&](const Json& one) { return is_of(q.value, one.get<std::string>()); })
              : is_of(q.value, q.rule.get<std::string>());
  return where(holds,
               fmt::format(" is {}, no {}", brief(q.value), several ? brief(q.rule) : q.rule.get<std::string>()));
}

Fault constant(const Question& q) {
  return where(q.value == q.rule, fmt::format(" is {}, not {}", brief(q.value), brief(q.rule)));
}

Fault one_of(const Question& q) {
  return where(std::ranges::find(q.rule, q.value) != q.rule.end(),
               fmt::format(" is {}, none of {}", brief(q.value), brief(q.rule)));
}

Fault any_of(const Question& q) {
  Fault last;
  for (const Json& one : q.rule) {
    last = q.schema.fault(one, q.value);
    if (!last) return last;
  }
  return fmt::format(" is {}, which may not be", brief(q.value));
}

Fault minimum(const Question& q) {
  return where(!q.value.is_number() || q.value >= q.rule,
               fmt::format(" is {}, below {}", brief(q.value), q.rule.dump()));
}

Fault maximum(const Question& q) {
  return where(!q.value.is_number() || q.value <= q.rule,
               fmt::format(" is {}, above {}", brief(q.value), q.rule.dump()));
}

Fault exclusive_minimum(const Question& q) {
  return where(!q.value.is_number() || q.value > q.rule,
               fmt::format(" is {}, not above {}", brief(q.value), q.rule.dump()));
}

Fault min_length(const Question& q) {
  return where(!q.value.is_string() || q.value.get_ref<const std::string&>().size() >= q.rule.get<std::size_t>(),
               " is too short");
}

Fault pattern(const Question& q) {
  return where(!q.value.is_string() || matches(q.rule.get<std::string>(), q.value.get_ref<const std::string&>()),
               fmt::format(" is {}, which does not look as it must", brief(q.value)));
}

Fault min_items(const Question& q) {
  return where(!q.value.is_array() || q.value.size() >= q.rule.get<std::size_t>(), " has too few items");
}

Fault max_items(const Question& q) {
  return where(!q.value.is_array() || q.value.size() <= q.rule.get<std::size_t>(), " has too many items");
}

Fault min_properties(const Question& q) {
  return where(!q.value.is_object() || q.value.size() >= q.rule.get<std::size_t>(), " has too few keys");
}

Fault items(const Question& q) {
  if (!q.value.is_array()) return {};
  for (std::size_t k = 0; k < q.value.size(); ++k)
    if (auto inner = q.schema.fault(q.rule, q.value[k])) return below(std::to_string(k), std::move(inner));
  return {};
}

Fault required(const Question& q) {
  if (!q.value.is_object()) return {};
  for (const Json& name : q.rule)
    if (!q.value.contains(name)) return fmt::format("{} is missing", name.get<std::string>());
  return {};
}

Fault properties(const Question& q) {
  if (!q.value.is_object()) return {};
  for (const auto& [name, rule] : q.rule.items())
    if (const auto found = q.value.find(name); found != q.value.end())
      if (auto inner = q.schema.fault(rule, *found)) return below(name, std::move(inner));
  return {};
}

Fault additional_properties(const Question& q) {
  if (!q.value.is_object()) return {};
  const Json* declared = q.beside("properties");
  for (const auto& [name, value] : q.value.items()) {
    if (declared != nullptr && declared->contains(name)) continue;
    if (q.rule.is_boolean() && !q.rule.get<bool>()) return fmt::format("{} is no key that belongs there", name);
    if (q.rule.is_object())
      if (auto inner = q.schema.fault(q.rule, value)) return below(name, std::move(inner));
  }
  return {};
}

Fault reference(const Question& q) { return q.schema.fault(q.schema.resolved(q.part), q.value); }

Fault nothing(const Question& /*question*/) { return {}; }

struct Keyword {
  std::string_view name;
  Fault (*fault)(const Question& question);
};

constexpr std::array keywords{
    Keyword{"$ref", reference}, Keyword{"type", type}, Keyword{"const", constant}, Keyword{"enum", one_of},
    Keyword{"anyOf", any_of}, Keyword{"minimum", minimum}, Keyword{"maximum", maximum},
    Keyword{"exclusiveMinimum", exclusive_minimum}, Keyword{"minLength", min_length}, Keyword{"pattern", pattern},
    Keyword{"minItems", min_items}, Keyword{"maxItems", max_items}, Keyword{"minProperties", min_properties},
    Keyword{"items", items}, Keyword{"required", required}, Keyword{"properties", properties},
    Keyword{"additionalProperties", additional_properties}, Keyword{"$schema", nothing}, Keyword{"$defs", nothing},
    Keyword{"title", nothing}, Keyword{"description", nothing}, Keyword{"deprecated", nothing},
    // Keywords of our own for tables and their columns; columns.hpp explains them.
    Keyword{"version", nothing}, Keyword{"last_reader_of_earlier", nothing}, Keyword{"deterministic", nothing},
    Keyword{"study", nothing}, Keyword{"method", nothing}, Keyword{"unit", nothing}, Keyword{"key", nothing},
    Keyword{"digested", nothing}, Keyword{"of_machine", nothing}, Keyword{"accuses", nothing},
    Keyword{"of_promise", nothing}, Keyword{"at_most", nothing}, Keyword{"across", nothing},
    Keyword{"measures", nothing}, Keyword{"ascending", nothing}, Keyword{"for_each", nothing}};

const Keyword& keyword_of(std::string_view name) {
  const auto found = std::ranges::find(keywords, name, &Keyword::name);
  if (found == keywords.end()) throw std::invalid_argument(fmt::format("JSON Schema: no keyword {}", name));
  return *found;
}

/// Throws std::invalid_argument where a schema, or one within it, has an unknown keyword.
void check(const Json& part) {
  if (!part.is_object()) return;
  for (const auto& [name, rule] : part.items()) {
    (void)keyword_of(name);
    if (name == "properties" || name == "$defs" || name == "anyOf")
      for (const Json& inner : rule) check(inner);
    if (name == "items" || name == "additionalProperties") check(rule);
  }
}

}  // namespace

Schema::Schema(std::string_view text) : document_(Json::parse(text)) { check(document_); }

std::optional<std::string> Schema::fault(const Json& part, const Json& value) const {
  for (const auto& [name, rule] : part.items())
    if (auto found = keyword_of(name).fault({*this, part, rule, value})) return found;
  return std::nullopt;
}

const Schema::Json& Schema::resolved(const Json& part) const {
  return part.contains("$ref") ? resolved(referred(part)) : part;
}

const Schema::Json& Schema::referred(const Json& part) const {
  return document_.at(Json::json_pointer(part.at("$ref").get_ref<const std::string&>().substr(1)));
}

const Schema& manifest_schema() {
  static const Schema schema(manifest_schema_text);
  return schema;
}

const Schema& machine_schema() {
  static const Schema schema(machine_schema_text);
  return schema;
}

const Schema& tables_schema() {
  static const Schema schema(tables_schema_text);
  return schema;
}

}  // namespace bezierbench::bundle
