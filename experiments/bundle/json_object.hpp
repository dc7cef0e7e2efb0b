// SPDX-License-Identifier: MIT
// The JSON files of a bundle, read with messages that say where they are damaged.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace bezierbench::bundle {

/// The object that `text` holds, keys in its order. Throws Failure(Exit::input_output): "FILE_NAME:LINE:COLUMN: ..."
/// for malformed JSON, "FILE_NAME: ..." for what is no object, nests too deep or has a number beyond every double.
[[nodiscard]] nlohmann::ordered_json parse_json_object(std::string_view text, std::string_view file_name);

}  // namespace bezierbench::bundle
