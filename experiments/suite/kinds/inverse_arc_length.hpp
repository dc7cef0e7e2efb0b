// SPDX-License-Identifier: MIT
// Keys of studies of the parameter at a length.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct InverseArcLengthKeys {
  std::vector<double> tolerance;  ///< relative to the length of the whole curve

  static const Kind& kind();
};

}  // namespace bezierbench::suite
