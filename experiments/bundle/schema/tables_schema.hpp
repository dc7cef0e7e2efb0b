// SPDX-License-Identifier: MIT
// tables.schema.json, for those who read more of it than columns.hpp gives.
#pragma once

#include <nlohmann/json.hpp>

namespace bezierbench::bundle {

[[nodiscard]] const nlohmann::ordered_json& tables_schema();

/// The part of the schema that the `$ref` of `part` names. It may have a `$ref` itself.
[[nodiscard]] const nlohmann::ordered_json& referred(const nlohmann::ordered_json& part);

}  // namespace bezierbench::bundle
