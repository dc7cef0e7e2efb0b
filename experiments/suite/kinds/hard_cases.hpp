// SPDX-License-Identifier: MIT
// Keys of studies that look for inputs at which rounding once is hard.
#pragma once

#include <cstdint>

namespace bezierbench::suite {

struct Kind;

struct HardCasesKeys {
  std::int64_t kept = 8;  ///< cases of each family and search

  static const Kind& kind();
};

}  // namespace bezierbench::suite
