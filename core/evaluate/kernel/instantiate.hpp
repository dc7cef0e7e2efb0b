// SPDX-License-Identifier: MIT
// Turns the rosters into tables of function pointers; included by one translation unit per scalar type.
#pragma once

#include <array>
#include <type_traits>

#include "core/convert/roster.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/kernel/points/point_units.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench::instantiate {

template <Conversion C, class Scalar, int Dimension>
constexpr ConversionKernel<Scalar> conversion_kernel() {
  return {&C::info, Dimension, convert_into<C, Dimension, Scalar>};
}

/// What a path ends in; any other method is its own evaluator.
template <class E>
struct LastOf {
  using Type = E;
};
template <Path E>
struct LastOf<E> {
  using Type = typename E::Second;
};
template <class E>
using EvaluatorOf = typename LastOf<E>::Type;

template <class Scalar, int Dimension, class... Es>
std::span<const Kernel<Scalar>> table_of(TypeList<Es...>) {
  static_assert((std::is_trivially_destructible_v<PreparedOf<Es, Scalar, Dimension>> && ...));
  static const std::array<Kernel<Scalar>, sizeof...(Es)> table{
      kernel<Es, Scalar, Dimension>(evaluate_function<EvaluatorOf<Es>, Scalar, Dimension>())...};
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
