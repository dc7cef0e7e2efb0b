// SPDX-License-Identifier: MIT
// Keys of searches for the inputs with the largest error.
#pragma once

#include <cstdint>

namespace bezierbench::suite {

struct Kind;

struct SearchKeys {
  std::int64_t budget = 0;  ///< inputs that the search may try per cell and method

  static const Kind& kind();
};

}  // namespace bezierbench::suite
