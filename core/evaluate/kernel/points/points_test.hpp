// SPDX-License-Identifier: MIT
// The kernels with the axes of a point side by side, with the degree known at compile time and at run time, against the
// methods for numbers. Each scalar is tested in a unit of its own, which takes long to compile.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "core/convert/roster.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"
#include "core/evaluate/roster.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench::points_test {

/// Every degree that has a kernel of its own and some beyond, and those about which recurrences change their code.
inline constexpr std::array degrees{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
                                    14, 15, 16, 17, 18, 21, 24, 31, 32, 33, 34, 48, 65};

/// Control points in [-1, 1], with zeros among them.
template <class Scalar>
std::vector<Scalar> coefficients(int count) {
  std::vector<Scalar> values;
  for (int k = 0; k < count; ++k) values.push_back(static_cast<Scalar>((k * 7919) % 1009) / Scalar(504) - Scalar(1));
  return values;
}

template <class Scalar>
bool same_bits(Scalar a, Scalar b) {
  using Bits = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// The path to an evaluator whose form no curve is given in; any other evaluator itself.
template <class E>
struct PathTo {
  using Type = E;
};
template <>
struct PathTo<HornerDoubleDouble> {
  using Type = Via<ExactToPowerDoubleDouble, HornerDoubleDouble>;
};
template <>
struct PathTo<HornerCentered> {
  using Type = Via<DifferencesCentered, HornerCentered>;
};

/// Points of the curves that the axes are by themselves: the method for numbers, in one dimension.
template <class M, class Scalar>
std::vector<Scalar> axis_by_axis(int dimension, int degree, const std::vector<Scalar>& values,
                                 const std::vector<Scalar>& t) {
  const auto axes = static_cast<std::size_t>(dimension);
  std::vector<Scalar> points(t.size() * axes);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::vector<Scalar> of_axis;
    for (std::size_t k = axis; k < values.size(); k += axes) of_axis.push_back(values[k]);
    const auto state = M::prepare(instantiate::load<M::info.form, 1>(view(M::info.form, 1, degree, of_axis)));
    for (std::size_t k = 0; k < t.size(); ++k) points[k * axes + axis] = M::evaluate(state, t[k])[0];
  }
  return points;
}

/// Runs the functions behind the kernel of a method, each in the units of the program.
template <class E, class Scalar>
void expect_every_way_to_agree() {
  using M = typename PathTo<E>::Type;
  const std::vector<Scalar> t{0, 1, Scalar(0.5), Scalar(0.3), Scalar(0x1p-30), Scalar(0.9), Scalar(-0.25), Scalar(1.5)};
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const auto* kernel = find_kernel<Scalar>(M::info.id, M::info.form, dimension);
    ASSERT_NE(kernel, nullptr) << M::info.id;
    for (const int n : degrees) {
      if (!M::info.template supports<Scalar>(n)) continue;
      const auto values = coefficients<Scalar>((n + 1) * dimension);
      const auto expected = axis_by_axis<M>(dimension, n, values, t);
      const PreparedState<Scalar> state(*kernel, view(M::info.form, dimension, n, values));
      // As it is timed; and the function for max_degree evaluates curves of every degree.
      for (const int function_degree : {n, max_degree}) {
        std::vector<Scalar> points(expected.size());
        kernel->evaluate_for(function_degree)(state.get(), t, points.data());
        for (std::size_t k = 0; k < points.size(); ++k)
          ASSERT_TRUE(same_bits(points[k], expected[k]))
              << M::info.id << ", degree " << n << ", dimension " << dimension << ", function for degree "
              << function_degree << ", value " << k << ": " << points[k] << " for " << expected[k];
      }
    }
  }
}

template <class List>
struct TypesOf;
template <class... Es>
struct TypesOf<TypeList<Es...>> {
  using Type = testing::Types<Es...>;
};

struct ByMethod {
  template <class E>
  static std::string GetName(int place) {
    return std::to_string(place) + "_" + std::string(E::info.id);
  }
};

using EveryEvaluator = TypesOf<Evaluators>::Type;

}  // namespace bezierbench::points_test
