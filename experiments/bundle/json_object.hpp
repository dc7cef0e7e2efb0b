// SPDX-License-Identifier: MIT
// The JSON files of a bundle, parsed with messages that name the place of an error.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace bezierbench::bundle {

/// The object that `text` holds, its keys in their order. Throws Failure(Exit::input_output): "FILE_NAME:LINE:COLUMN:
/// ..." for malformed JSON, "FILE_NAME: ..." for a value that is not an object, is nested too deep or has a number
/// beyond every double.
[[nodiscard]] nlohmann::ordered_json parse_json_object(std::string_view text, std::string_view file_name);

}  // namespace bezierbench::bundle
