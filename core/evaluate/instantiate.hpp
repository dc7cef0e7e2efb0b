// SPDX-License-Identifier: MIT
// Turns the rosters into tables of function pointers; included by one translation unit per scalar type.
#pragma once

#include <array>
#include <new>
#include <type_traits>

#include "core/convert/roster.hpp"
#include "core/evaluate/kernel.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench::instantiate {

template <Form F, int Dimension, class Scalar>
Curve<F, Scalar, Dimension> load(const CurveView<Scalar>& view) {
  if constexpr (F == Form::rational) {
    Curve<F, Scalar, Dimension> curve(view.degree);
    curve.points = load<Form::bernstein, Dimension>(view);
    for (int i = 0; i <= view.degree; ++i) curve.weights[i] = view.weights[static_cast<std::size_t>(i)];
    return curve;
  } else {
    Curve<F, Scalar, Dimension> curve(view.degree);
    for (int i = 0; i <= view.degree; ++i)
      for (int axis = 0; axis < Dimension; ++axis) curve(axis, i) = view(axis, i);
    return curve;
  }
}

template <Form F, class Scalar, int Dimension>
void append(const Curve<F, Scalar, Dimension>& curve, std::vector<Scalar>& coefficients) {
  if constexpr (F == Form::power_double_double) {
    append(curve.high, coefficients);
    append(curve.low, coefficients);
  } else {
    for (int i = 0; i <= curve.degree(); ++i)
      for (int axis = 0; axis < Dimension; ++axis) coefficients.push_back(curve(axis, i));
  }
}

/// A converted path names its conversion.
template <class E>
concept Path = requires {
  typename E::First;
};

template <class E>
constexpr Form evaluated_form() {
  if constexpr (Path<E>)
    return E::First::target;
  else
    return E::info.form;
}

template <class E, class Scalar, int Dimension>
constexpr auto converted() -> void (*)(const CurveView<Scalar>&, std::vector<Scalar>&) {
  if constexpr (Path<E>)
    return [](const CurveView<Scalar>& view, std::vector<Scalar>& coefficients) {
      coefficients.clear();
      append(E::First::convert(load<E::info.form, Dimension>(view)), coefficients);
    };
  else
    return nullptr;
}

template <Evaluator E, class Scalar, int Dimension>
constexpr Kernel<Scalar> kernel() {
  using Prepared = PreparedOf<E, Scalar, Dimension>;
  static_assert(std::is_trivially_destructible_v<Prepared>);
  return {&E::info,
          Dimension,
          sizeof(Prepared),
          alignof(Prepared),
          [](const CurveView<Scalar>& view, void* prepared) {
            ::new (prepared) Prepared(E::prepare(load<E::info.form, Dimension>(view)));
          },
          [](const void* prepared, std::span<const Scalar> t, Scalar* points) {
            const auto& state = *static_cast<const Prepared*>(prepared);
            for (std::size_t k = 0; k < t.size(); ++k) {
              const Point<Scalar, Dimension> point = E::evaluate(state, t[k]);
              for (std::size_t axis = 0; axis < Dimension; ++axis)
                points[k * Dimension + axis] = point[static_cast<Eigen::Index>(axis)];
            }
          },
          evaluated_form<E>(),
          converted<E, Scalar, Dimension>()};
}

template <Conversion C, class Scalar, int Dimension>
constexpr ConversionKernel<Scalar> conversion_kernel() {
  return {&C::info, Dimension, [](const CurveView<Scalar>& view, Scalar* coefficients) {
            const auto converted = C::convert(load<C::info.form, Dimension>(view));
            for (int i = 0; i <= view.degree; ++i)
              for (int axis = 0; axis < Dimension; ++axis) *coefficients++ = converted(axis, i);
          }};
}

template <class Scalar, int Dimension, class... Es>
std::span<const Kernel<Scalar>> table_of(TypeList<Es...>) {
  static constexpr std::array<Kernel<Scalar>, sizeof...(Es)> table{kernel<Es, Scalar, Dimension>()...};
  return table;
}

template <class Scalar, int Dimension, class... Cs>
std::span<const ConversionKernel<Scalar>> conversion_table_of(TypeList<Cs...>) {
  static constexpr std::array<ConversionKernel<Scalar>, sizeof...(Cs)> table{
      conversion_kernel<Cs, Scalar, Dimension>()...};
  return table;
}

using Methods = typename PathsOf<Conversions, Evaluators>::Type;
using PlainConversions = typename GivenTargets<Conversions>::Type;

template <class... Cs>
std::span<const MethodInfo* const> infos_of(TypeList<Cs...>) {
  static constexpr std::array<const MethodInfo*, sizeof...(Cs)> infos{&Cs::info...};
  return infos;
}

}  // namespace bezierbench::instantiate

namespace bezierbench {

template <class Scalar>
std::span<const Kernel<Scalar>> kernels(int dimension) {
  using instantiate::Methods;
  switch (dimension) {
    case 1: return instantiate::table_of<Scalar, 1>(Methods{});
    case 2: return instantiate::table_of<Scalar, 2>(Methods{});
    case 3: return instantiate::table_of<Scalar, 3>(Methods{});
    default: return {};
  }
}

template <class Scalar>
std::span<const ConversionKernel<Scalar>> conversion_kernels(int dimension) {
  switch (dimension) {
    case 1: return instantiate::conversion_table_of<Scalar, 1>(instantiate::PlainConversions{});
    case 2: return instantiate::conversion_table_of<Scalar, 2>(instantiate::PlainConversions{});
    case 3: return instantiate::conversion_table_of<Scalar, 3>(instantiate::PlainConversions{});
    default: return {};
  }
}

}  // namespace bezierbench
