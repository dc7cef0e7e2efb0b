// SPDX-License-Identifier: MIT
// The parameters and degrees at which properties are decided.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/method.hpp"

namespace bezierbench::requirements {

/// The ends, their neighbours, the middle, and both sides of [0, 1].
inline std::vector<double> parameters() { return {0, 1, 0.5, 0.3, 0x1p-30, 1 - 0x1p-53, 0.9, -0.25, 1.5}; }

/// Those at which the method has a value: outside [0, 1] sums of weights may vanish, and some methods end there.
inline std::vector<double> parameters_for(const MethodInfo& info) {
  auto ts = parameters();
  if (info.form == Form::rational || info.unit_interval_only)
    std::erase_if(ts, [](double t) { return t < 0 || t > 1; });
  return ts;
}

/// Those of `degrees` that the method takes.
template <class Scalar = double>
std::vector<int> degrees_for(const MethodInfo& info, std::initializer_list<int> degrees) {
  std::vector<int> taken = degrees;
  std::erase_if(taken, [&](int degree) { return !info.supports<Scalar>(degree); });
  return taken;
}

}  // namespace bezierbench::requirements
