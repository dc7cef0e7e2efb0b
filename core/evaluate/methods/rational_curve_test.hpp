// SPDX-License-Identifier: MIT
// For tests of schemes in other bases: curves of one coordinate over any scalar, rational numbers included, and the
// test that only rounding distinguishes a scheme from de Casteljau's.
#pragma once

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cstddef>
#include <vector>

#include "core/evaluate/methods/de_casteljau.hpp"

namespace bezierbench {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

template <class Scalar>
Curve<Form::bernstein, Scalar, 1> curve_of(const std::vector<Scalar>& values) {
  Curve<Form::bernstein, Scalar, 1> curve(static_cast<int>(values.size()) - 1);
  for (int i = 0; i <= curve.degree(); ++i) curve(0, i) = values[static_cast<std::size_t>(i)];
  return curve;
}

/// b_k = 1, the other n control points 0.
template <class Scalar>
std::vector<Scalar> unit_vector(int n, int k) {
  std::vector<Scalar> values(static_cast<std::size_t>(n) + 1, Scalar(0));
  values[static_cast<std::size_t>(k)] = Scalar(1);
  return values;
}

template <class Method>
void expect_de_casteljau_when_nothing_rounds() {
  for (int n = 0; n <= 30; ++n) {
    std::vector<Rational> values;
    for (int i = 0; i <= n; ++i) values.emplace_back((7 * i * i - 11 * i + 3) % 17, 1 + i % 5);
    const auto curve = curve_of(values);
    const auto prepared = Method::prepare(curve);
    for (const Rational& t : {Rational(1, 3), Rational(4, 5), Rational(-2, 7)})
      EXPECT_EQ(Method::evaluate(prepared, t)[0], DeCasteljau::evaluate(curve, t)[0]) << "n " << n << " t " << t;
  }
}

}  // namespace bezierbench
