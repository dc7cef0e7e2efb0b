// SPDX-License-Identifier: MIT
// Checks of bundle.json and machine.json against their JSON Schemas, the files of schema/.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bezierbench::bundle {

/// Why `text` cannot be bundle.json: the line `FILE_NAME: PLACE: what is wrong`, or that of parse_json_object(). Empty
/// where it can.
[[nodiscard]] std::optional<std::string> manifest_fault(std::string_view text, const std::string& file_name);

/// The same for machine.json.
[[nodiscard]] std::optional<std::string> machine_fault(std::string_view text, const std::string& file_name);

}  // namespace bezierbench::bundle
