// SPDX-License-Identifier: MIT
// Keys of studies of derivatives.
#pragma once

#include <vector>

namespace bezierbench::suite {

struct Kind;

struct DerivativeKeys {
  std::vector<int> order;  ///< orders of the derivatives

  static const Kind& kind();
};

}  // namespace bezierbench::suite
