// SPDX-License-Identifier: MIT
// Curves and arrays of the caller, checked.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "bindings/c/status.hpp"
#include "core/curve_view.hpp"

namespace bezierbench::c {

inline constexpr int max_dimension = 3;

/// Throws Refused(BB_ERROR_NOT_FINITE) for a value that is NaN or infinite.
template <class Scalar>
void require_finite(std::span<const Scalar> values) {
  require(std::ranges::all_of(values, [](Scalar x) { return std::isfinite(x); }), BB_ERROR_NOT_FINITE);
}

/// `count` finite values at `values`, which may be null for none.
template <class Scalar>
std::span<const Scalar> finite_values(const Scalar* values, std::size_t count) {
  if (count == 0) return {};
  require_pointers(values);
  const std::span<const Scalar> result(values, count);
  require_finite(result);
  return result;
}

/// A curve in Bernstein form. Throws Refused for arguments that do not make a curve.
template <class Scalar>
CurveView<Scalar> bezier_curve(int dimension, int degree, const Scalar* points) {
  require(dimension >= 1 && dimension <= max_dimension, BB_ERROR_DIMENSION);
  require(degree >= 0 && degree <= max_degree, BB_ERROR_DEGREE);
  const auto values = (static_cast<std::size_t>(degree) + 1) * static_cast<std::size_t>(dimension);
  return {Form::bernstein, dimension, degree, finite_values(points, values), {}};
}

/// A curve of the caller. Throws Refused for arguments that do not make a curve.
CurveView<double> curve_of(const bb_curve* curve);

/// The same for functions that take the Bernstein form only.
CurveView<double> bernstein_curve_of(const bb_curve* curve);

/// The bb_form of a form in which curves are given.
bb_form form_of(Form form);

}  // namespace bezierbench::c
