// SPDX-License-Identifier: MIT
// Methods behind function pointers: the compile-time concept ends here. The code that is timed is the code that is
// judged: these kernels, in their own translation unit, or those of core/batch for many at once, which tests hold to
// the same bits.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// Evaluates a prepared curve at every t; points[k * dimension + axis] is the point at t[k].
template <class Scalar>
using EvaluatePoints = void (*)(const void* prepared, std::span<const Scalar> t, Scalar* points);

/// `Kernel::evaluate_for` of a method with one function for all degrees.
template <class Scalar, EvaluatePoints<Scalar> evaluate>
EvaluatePoints<Scalar> for_every_degree(int /*degree*/) {
  return evaluate;
}

/// An evaluator or a converted path, instantiated for one scalar type and dimension, degree known at run time.
template <class Scalar>
struct Kernel {
  const MethodInfo* info;
  int dimension;
  std::size_t prepared_size;       ///< bytes that `prepare` fills
  std::size_t prepared_alignment;  ///< of those bytes
  /// Does all work per curve: constructs the state in `prepared` that the function of `evaluate_for` reads.
  void (*prepare)(const CurveView<Scalar>& curve, void* prepared);
  /// The function that evaluates prepared curves of this degree; callers look it up once for each curve. The function
  /// for `max_degree` evaluates curves of every degree.
  EvaluatePoints<Scalar> (*evaluate_for)(int degree);
  const MethodInfo* evaluator;   ///< the evaluator of a path; for other methods `info`
  const MethodInfo* conversion;  ///< the conversion of a path; nullptr for a method that takes curves as they are given
  Form evaluated_form;           ///< form of the coefficients that are evaluated
  /// The coefficients that a path evaluates, point by point (double-double: all high parts, then all low parts);
  /// nullptr for a method that takes curves as they are given.
  void (*converted)(const CurveView<Scalar>& curve, std::vector<Scalar>& coefficients);
  /// Ends what `prepare` constructed; nullptr where there is nothing to do. Methods in core own no memory; an object of
  /// another library may.
  void (*destroy)(void* prepared) = nullptr;
};

/// A conversion for one scalar type and dimension.
template <class Scalar>
struct ConversionKernel {
  const MethodInfo* info;
  int dimension;
  /// Writes the (degree + 1) * dimension coefficients of the other form, point by point.
  void (*convert)(const CurveView<Scalar>& curve, Scalar* coefficients);
};

/// All evaluators and converted paths, in roster order. Dimension is 1, 2 or 3.
template <class Scalar>
std::span<const Kernel<Scalar>> kernels(int dimension);

/// The data of every conversion, in roster order, those to forms inside paths included.
std::span<const MethodInfo* const> conversion_infos();

/// All conversions to a form in which curves are given, in roster order. Dimension is 1, 2 or 3.
template <class Scalar>
std::span<const ConversionKernel<Scalar>> conversion_kernels(int dimension);

/// The entry for a method of this form; nullptr if there is none.
template <class Scalar>
const Kernel<Scalar>* find_kernel(std::string_view id, Form form, int dimension) {
  for (const auto& kernel : kernels<Scalar>(dimension))
    if (kernel.info->id == id && kernel.info->form == form) return &kernel;
  return nullptr;
}

/// The entry for a conversion from this form; nullptr if there is none.
template <class Scalar>
const ConversionKernel<Scalar>* find_conversion(std::string_view id, Form from, int dimension) {
  for (const auto& kernel : conversion_kernels<Scalar>(dimension))
    if (kernel.info->id == id && kernel.info->form == from) return &kernel;
  return nullptr;
}

}  // namespace bezierbench
