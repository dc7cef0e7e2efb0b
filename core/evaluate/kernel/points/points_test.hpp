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

#include "core/evaluate/evaluation_test.hpp"
#include "core/evaluate/kernel/points/point_kernel.hpp"
#include "core/evaluate/kernel/points/point_units.hpp"
#include "core/evaluate/roster.hpp"

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

template <class E, class Scalar, int Dimension>
PreparedOf<E, Scalar, Dimension> prepared(int degree, const std::vector<Scalar>& values) {
  if constexpr (E::info.form == Form::power_double_double) {
    const auto part = instantiate::load<Form::power, Dimension>(view(Form::power, Dimension, degree, values));
    Curve<Form::power_double_double, Scalar, Dimension> curve(degree);
    curve.high = part;
    curve.low = part;
    return E::prepare(curve);
  } else {
    return E::prepare(instantiate::load<E::info.form, Dimension>(view(E::info.form, Dimension, degree, values)));
  }
}

template <class E, class Scalar, int Dimension>
void expect_same_bits(int degree, const char* way, EvaluatePoints<Scalar> evaluate) {
  const std::vector<Scalar> t{0, 1, Scalar(0.5), Scalar(0.3), Scalar(0x1p-30), Scalar(0.9), Scalar(-0.25), Scalar(1.5)};
  const auto state = prepared<E, Scalar, Dimension>(degree, coefficients<Scalar>((degree + 1) * Dimension));
  std::vector<Scalar> expected(t.size() * Dimension);
  std::vector<Scalar> points(t.size() * Dimension);
  instantiate::evaluate_one_by_one<E, Scalar, Dimension>(&state, t, expected.data());
  evaluate(&state, t, points.data());
  for (std::size_t k = 0; k < points.size(); ++k)
    ASSERT_TRUE(same_bits(points[k], expected[k]))
        << E::info.id << ", degree " << degree << ", dimension " << Dimension << ", " << way
        << ", t = " << t[k / Dimension] << ": " << points[k] << " for " << expected[k];
}

template <class E, class Scalar, int Dimension>
void expect_every_way_to_agree() {
  if constexpr (instantiate::SideBySide<E, Scalar, Dimension>) {
    for (const int n : degrees) {
      if (!E::info.template supports<Scalar>(n)) continue;
      expect_same_bits<E, Scalar, Dimension>(n, "as it is timed",
                                             instantiate::evaluate_function<E, Scalar, Dimension>()(n));
      // The function for max_degree evaluates curves of every degree.
      expect_same_bits<E, Scalar, Dimension>(n, "degree at run time",
                                             instantiate::evaluate_function<E, Scalar, Dimension>()(max_degree));
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
