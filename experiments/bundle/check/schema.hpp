// SPDX-License-Identifier: MIT
// JSON Schema, as far as the files in schema/ use it. The library for it in Debian (valijson) matches patterns with
// std::regex, which overflows the stack on long fields, and bundles come from strangers.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace bezierbench::bundle {

// Regular expressions whose memory and time grow in proportion to the text, whoever wrote it.

/// Whether some part of `text` matches `pattern`, a POSIX extended regular expression, which is compiled once. A text
/// with a NUL byte never matches. Throws std::invalid_argument for an invalid pattern.
[[nodiscard]] bool matches(const std::string& pattern, const std::string& text);

/// A schema to check values with: keywords of draft 2020-12, `$ref` only within the same document.
class Schema {
 public:
  using Json = nlohmann::ordered_json;

  /// Parses the schema. Throws std::invalid_argument for a keyword that this class does not know, rather than ignore
  /// it.
  explicit Schema(std::string_view text);

  /// Where and how `value` violates the schema ("cpu.smt is missing"); empty where it does not.
  [[nodiscard]] std::optional<std::string> fault(const Json& value) const { return fault(document_, value); }
  /// The same for `part`, a part of this schema.
  [[nodiscard]] std::optional<std::string> fault(const Json& part, const Json& value) const;

  [[nodiscard]] const Json& document() const { return document_; }
  /// The schema that the `$ref` of `part` leads to, through any number of references; `part` itself without one.
  [[nodiscard]] const Json& resolved(const Json& part) const;
  /// The schema that the `$ref` of `part` names. It may have a `$ref` itself.
  [[nodiscard]] const Json& referred(const Json& part) const;

 private:
  Json document_;
};

/// The schemas of bundle.json, of machine.json and of the tables.
[[nodiscard]] const Schema& manifest_schema();
[[nodiscard]] const Schema& machine_schema();
[[nodiscard]] const Schema& tables_schema();

}  // namespace bezierbench::bundle
