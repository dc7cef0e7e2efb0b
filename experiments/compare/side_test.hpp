// SPDX-License-Identifier: MIT
// Sides made of text, for this folder's tests only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/compare/side.hpp"

namespace bezierbench::compare {

/// A side with these tables, as pairs of file name and text.
inline Side side_of(const std::string& name, const std::vector<std::pair<std::string, std::string>>& tables) {
  Side side{.name = name, .manifest = {}, .facts = {}, .tables = {}};
  side.manifest.seed = 1;
  for (const auto& [file, text] : tables) side.tables.emplace(file, bundle::parse_csv(text, name + "/" + file));
  return side;
}

}  // namespace bezierbench::compare
