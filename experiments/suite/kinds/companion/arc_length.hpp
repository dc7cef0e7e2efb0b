// SPDX-License-Identifier: MIT
// Keys of studies of arc lengths.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct ArcLengthKeys {
  std::vector<double> tolerance;  ///< relative to the length

  static const Kind& kind();
};

}  // namespace bezierbench::suite
