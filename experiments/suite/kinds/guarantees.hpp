// SPDX-License-Identifier: MIT
// Keys of studies that try to refute what methods may promise.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bezierbench::suite {

struct Kind;

struct GuaranteesKeys {
  std::int64_t budget = 0;              ///< inputs that the search may try per cell, method and property
  std::vector<std::string> properties;  ///< empty: all of them

  static const Kind& kind();
};

}  // namespace bezierbench::suite
