// SPDX-License-Identifier: MIT
// The keys of a [[study]] table: the one list that reader, overrides and writer go through.
#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

struct Field {
  std::string_view key;
  void (*read)(std::string_view source, std::string_view key, const toml::node& node, Study& out);
  std::string (*write)(const Study& study);  ///< TOML text of the value; empty where the key is to be left out
  bool settable;                             ///< with `--set key=v1,v2`
  bool single = false;                       ///< one value, not a list of them to be swept
  bool of_cells = false;                     ///< its values tell the cells of a study apart
};

/// All keys of a study, in the order in which they are written.
std::span<const Field> study_fields();

/// The field with that key; null where there is none.
const Field* find_field(std::string_view key);

}  // namespace bezierbench::suite
