// SPDX-License-Identifier: MIT
// Keys of roofline studies: batch kernels against the peak of the processor.
#pragma once

#include <vector>

#include "experiments/suite/values.hpp"

namespace bezierbench::suite {

struct Kind;

struct RooflineKeys {
  std::vector<Goal> goals;  ///< goals that batch kernels must reach

  static const Kind& kind();
};

}  // namespace bezierbench::suite
