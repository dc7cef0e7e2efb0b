// SPDX-License-Identifier: MIT
// JSON Schema, as far as the files in schema/ use it. The library for it in Debian (valijson) matches patterns with
// std::regex, which overflows the stack on long fields, and bundles come from strangers.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace bezierbench::bundle {

/// A schema to judge values by: keywords of draft 2020-12, `$ref` within the same document.
class Schema {
 public:
  using Json = nlohmann::ordered_json;

  /// Throws std::invalid_argument for a keyword that is not known here: it would be passed over in silence.
  explicit Schema(std::string_view text);

  /// Why `value` does not follow the schema, and where: "cpu.smt is missing". Nothing where it does.
  [[nodiscard]] std::optional<std::string> fault(const Json& value) const { return fault(document_, value); }
  /// The same for a part of the schema.
  [[nodiscard]] std::optional<std::string> fault(const Json& part, const Json& value) const;

  [[nodiscard]] const Json& document() const { return document_; }
  /// The schema that `part` refers to, or else `part` itself.
  [[nodiscard]] const Json& resolved(const Json& part) const;
  /// What the `$ref` of `part` names, which may have one itself.
  [[nodiscard]] const Json& referred(const Json& part) const;

 private:
  Json document_;
};

/// Of bundle.json, of machine.json and of the tables.
[[nodiscard]] const Schema& manifest_schema();
[[nodiscard]] const Schema& machine_schema();
[[nodiscard]] const Schema& tables_schema();

/// What is wrong with the text of machine.json: no JSON, or not after its schema. Nothing where all is well.
[[nodiscard]] std::optional<std::string> machine_fault(const std::string& machine_json);

}  // namespace bezierbench::bundle
