// SPDX-License-Identifier: MIT
// Keys of studies of inverse arc length: the parameter at a given length.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct InverseArcLengthKeys {
  std::vector<double> tolerance;  ///< relative to the length of the whole curve

  static const Kind& kind();
};

}  // namespace bezierbench::suite
