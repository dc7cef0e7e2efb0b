// SPDX-License-Identifier: MIT
// Keys of studies of splines through points.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct InterpolationKeys {
  std::vector<int> points;  ///< numbers of data points

  static const Kind& kind();
};

}  // namespace bezierbench::suite
