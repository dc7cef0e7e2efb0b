// SPDX-License-Identifier: MIT
// Keys of studies of fits near points.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct FittingKeys {
  std::vector<int> points;        ///< numbers of data points
  std::vector<double> tolerance;  ///< largest distance from the data

  static const Kind& kind();
};

}  // namespace bezierbench::suite
