// SPDX-License-Identifier: MIT
// A method that a user's program has compiled in, as the harness sees it.
#pragma once

#include <array>

#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::external {

/// Its kernels for dimensions 1, 2 and 3; those in float are null where it answers in double only.
struct OwnMethod {
  const MethodInfo* info;
  std::array<const Kernel<double>*, 3> kernels;
  std::array<const Kernel<float>*, 3> float_kernels;
};

}  // namespace bezierbench::external
