// SPDX-License-Identifier: MIT
// From a roster to a table of function pointers for each dimension, the same for all companion problems.
#pragma once

#include <array>
#include <span>

#include "core/method.hpp"

namespace bezierbench {

/// `MakeKernel::of<Method, dimension>()` for each method of the roster, in its order; for dimensions 1 to 3.
/// All dimensions are instantiated where this is called: kernels stay in the translation unit of their problem.
template <class Kernel, class MakeKernel, class... Methods>
std::span<const Kernel> kernels_of(TypeList<Methods...> /*roster*/, int dimension) {
  static constexpr std::array line{MakeKernel::template of<Methods, 1>()...};
  static constexpr std::array plane{MakeKernel::template of<Methods, 2>()...};
  static constexpr std::array space{MakeKernel::template of<Methods, 3>()...};
  switch (dimension) {
    case 1: return line;
    case 2: return plane;
    case 3: return space;
    default: return {};
  }
}

}  // namespace bezierbench
