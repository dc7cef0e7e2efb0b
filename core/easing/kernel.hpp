// SPDX-License-Identifier: MIT
// The methods for easing behind function pointers.
#pragma once

#include <span>

#include "core/easing/easing.hpp"

namespace bezierbench {

/// One method. Both functions prepare the curve, which is_easing() must accept, and answer at each x, none NaN, in the
/// order given.
struct EasingKernel {
  const MethodInfo* info;
  bool is_correctly_rounded;  ///< for x in [0, 1]
  void (*ease)(const EasingCurve<double>& curve, std::span<const double> x, Eased<double>* answers);
  void (*ease_float)(const EasingCurve<float>& curve, std::span<const float> x, Eased<float>* answers);

  template <class Scalar>
  void operator()(const EasingCurve<Scalar>& curve, std::span<const Scalar> x, Eased<Scalar>* answers) const {
    if constexpr (sizeof(Scalar) == sizeof(float))
      ease_float(curve, x, answers);
    else
      ease(curve, x, answers);
  }
};

/// All methods, in roster order.
std::span<const EasingKernel> easing_kernels();

}  // namespace bezierbench
