// SPDX-License-Identifier: MIT
// Keys of accuracy studies: errors of points on random curves.
#pragma once

#include <cstdint>
#include <string>

namespace bezierbench::suite {

struct Kind;

struct AccuracyKeys {
  std::int64_t decomposed_trials = 0;  ///< trials per cell whose error is split into its parts
  std::string published;               ///< file of printed values in reference/published; may be empty

  static const Kind& kind();
};

}  // namespace bezierbench::suite
