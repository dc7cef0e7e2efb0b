// SPDX-License-Identifier: MIT
// Keys of studies of points on grids.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct GridKeys {
  std::vector<int> points;  ///< numbers of points, each a power of two and one

  static const Kind& kind();
};

}  // namespace bezierbench::suite
