// SPDX-License-Identifier: MIT
// A method that a user's program has compiled in, as the harness sees it.
#pragma once

#include <array>

#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::external {

/// Its kernels in double, for dimensions 1, 2 and 3.
struct OwnMethod {
  const MethodInfo* info;
  std::array<const Kernel<double>*, 3> kernels;
};

}  // namespace bezierbench::external
