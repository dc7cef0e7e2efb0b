// SPDX-License-Identifier: MIT
// Properties of the scalar type that methods compute in.
#pragma once

#include "experiments/suite/suite.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/rational.hpp"

namespace bezierbench::judge {

template <class Scalar>
struct ScalarFacts;

template <>
struct ScalarFacts<float> {
  static constexpr suite::ScalarKind kind = suite::ScalarKind::float32;
  static constexpr reference::Arithmetic arithmetic = reference::float_arithmetic;
  static constexpr reference::Format format = reference::binary32;
};

template <>
struct ScalarFacts<double> {
  static constexpr suite::ScalarKind kind = suite::ScalarKind::float64;
  static constexpr reference::Arithmetic arithmetic = reference::double_arithmetic;
  static constexpr reference::Format format = reference::binary64;
};

/// Calls `of` with a 0 of the scalar type and returns what it returns: turns a value of ScalarKind into a type.
template <class Of>
decltype(auto) with_scalar(suite::ScalarKind scalar, Of&& of) {
  return scalar == suite::ScalarKind::float32 ? of(float{}) : of(double{});
}

}  // namespace bezierbench::judge
