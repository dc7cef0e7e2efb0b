// SPDX-License-Identifier: MIT
// Curves and arrays of the caller, checked.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "bindings/c/status.hpp"
#include "core/api/recommended.hpp"
#include "core/curve_view.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/method.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::c {

inline constexpr int max_dimension = 3;

/// Throws Refused(BB_ERROR_NOT_FINITE) for a value that is NaN or infinite. For all others the bits of x - x are 0; several
/// vectors of them are collected at once.
template <class Scalar>
void require_finite(std::span<const Scalar> values) {
  using Bits = std::conditional_t<sizeof(Scalar) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  constexpr std::size_t at_once = 128 / sizeof(Scalar);
  const auto bits = [](Scalar x) { return std::bit_cast<Bits>(x - x); };
  std::array<Bits, at_once> found{};
  std::size_t k = 0;
  for (; k + at_once <= values.size(); k += at_once)
    for (std::size_t j = 0; j < at_once; ++j) found[j] |= bits(values[k + j]);
  for (; k < values.size(); ++k) found[0] |= bits(values[k]);
  require(std::ranges::all_of(found, [](Bits some) { return some == 0; }), BB_ERROR_NOT_FINITE);
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

/// Throws Refused unless curves may have this dimension and degree.
void require_shape(int dimension, int degree);

/// A curve in Bernstein form. Throws Refused for arguments that do not make a curve.
template <class Scalar>
CurveView<Scalar> bezier_curve(int dimension, int degree, const Scalar* points) {
  require_shape(dimension, degree);
  const auto values = (static_cast<std::size_t>(degree) + 1) * static_cast<std::size_t>(dimension);
  return {Form::bernstein, dimension, degree, finite_values(points, values), {}};
}

/// The degree + 1 weights of a curve. Throws Refused for those that do not make one.
template <class Scalar>
std::span<const Scalar> weights_of(const Scalar* weights, int degree) {
  const auto values = finite_values(weights, static_cast<std::size_t>(degree) + 1);
  require(std::ranges::any_of(values, [](Scalar weight) { return weight != 0; }), BB_ERROR_NO_POINT);
  return values;
}

/// The form of a bb_form. Throws Refused for other numbers.
Form form_at(int form);

/// A curve of the caller. Throws Refused for arguments that do not make a curve.
CurveView<double> curve_of(const bb_curve* curve);

/// The same for functions that take the Bernstein form only.
CurveView<double> bernstein_curve_of(const bb_curve* curve);

/// The bb_form of a form in which curves are given.
bb_form form_of(Form form);

}  // namespace bezierbench::c

// What a bb_curves is: the curves of a file, or the spans of a B-spline curve.

struct bb_curves {
  bezierbench::curves::CurveSet set;
};

// The method of an id in the table of a problem.

namespace bezierbench::c {

/// The entry of the table (entries have an `info`) that takes the curve. Throws Refused that says whether the id, the
/// form or the degree is wrong.
template <class Table, class Scalar>
const typename Table::element_type& chosen(const Table& table, const char* id, const CurveView<Scalar>& curve) {
  require_pointers(id);
  const std::string_view wanted = id;
  bb_status reason = BB_ERROR_METHOD;
  for (const auto& entry : table) {
    if (entry.info->id != wanted) continue;
    if (entry.info->form != curve.form) {
      if (reason == BB_ERROR_METHOD) reason = BB_ERROR_FORM;  // another entry of this id may take the form
    } else if (entry.info->template supports<Scalar>(curve.degree)) {
      return entry;
    } else {
      reason = BB_ERROR_DEGREE;
    }
  }
  throw Refused{reason};
}

/// The id of the evaluator that a null id stands for: that of the C++ function evaluate().
template <class Scalar>
const char* recommended_id(Form form, int degree) {
  switch (form) {
    case Form::power: return recommended<Form::power, Scalar>(degree).id.data();
    case Form::rational: return recommended<Form::rational, Scalar>(degree).id.data();
    default: return recommended<Form::bernstein, Scalar>(degree).id.data();
  }
}

/// The evaluator of this id for the curve; the recommended one for a null id. Throws as chosen().
template <class Scalar>
const Kernel<Scalar>& evaluator(const char* id, const CurveView<Scalar>& curve) {
  return chosen(kernels<Scalar>(curve.dimension), id != nullptr ? id : recommended_id<Scalar>(curve.form, curve.degree),
                curve);
}

/// Throws Refused unless the parameters are finite and in the domain of the method.
template <class Scalar>
void require_parameters(const MethodInfo& info, std::span<const Scalar> t) {
  require_finite(t);
  if (!info.unit_interval_only) return;
  bool inside = true;
  for (const Scalar x : t) inside = inside & (x >= 0) & (x <= 1);
  require(inside, BB_ERROR_PARAMETER);
}

/// `count` finite parameters in the domain of the method.
template <class Scalar>
std::span<const Scalar> parameters(const MethodInfo& info, const Scalar* t, std::size_t count) {
  if (count == 0) return {};
  require_pointers(t);
  require_parameters(info, std::span(t, count));
  return {t, count};
}

}  // namespace bezierbench::c
