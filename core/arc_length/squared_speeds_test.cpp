// SPDX-License-Identifier: MIT
// Eight speeds computed at once have the bits of single ones.
#include "core/arc_length/squared_speeds.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/arc_length/fixed_degree.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"

namespace bezierbench {
namespace {

template <int Dimension>
double squared_norm_at(const Curve<Form::bernstein, double, Dimension>& curve, double t) {
  const auto point = DeCasteljau::evaluate(DeCasteljau::prepare(curve), t);
  double sum = 0;
  for (int axis = 0; axis < Dimension; ++axis) sum += point[axis] * point[axis];
  return sum;
}

template <int Dimension>
void expect_those_of_de_casteljau() {
  const auto squared_speeds = std::make_unique<SquaredSpeeds<Dimension>>();  // one object serves all curves below
  Inputs inputs(11);
  for (const int degree : {20, 0, 1, 2, 3, 5, 10, max_degree, 4, 0}) {
    const auto points = inputs.coefficients(degree, Dimension);
    const auto h =
        instantiate::load<Form::bernstein, Dimension>(CurveView<double>{Form::bernstein, Dimension, degree, points});
    std::array<double, 8> parameters{0, 1, 0.5};
    for (std::size_t k = 3; k < parameters.size(); ++k) parameters[k] = inputs.unit();
    const auto expect_right = [&](const auto& squares) {
      for (std::size_t k = 0; k < parameters.size(); ++k)
        EXPECT_EQ(squares[k], squared_norm_at(h, parameters[k])) << degree << " " << parameters[k];
    };
    expect_right((*squared_speeds)(h, parameters));
    with_fixed_degree(h, [&](const auto& fixed) { expect_right((*squared_speeds)(fixed, parameters)); });
  }
}

TEST(SquaredSpeeds, AreThoseOfDeCasteljau) {
  expect_those_of_de_casteljau<1>();
  expect_those_of_de_casteljau<2>();
  expect_those_of_de_casteljau<3>();
}

}  // namespace
}  // namespace bezierbench
