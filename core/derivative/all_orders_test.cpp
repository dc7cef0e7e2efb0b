// SPDX-License-Identifier: MIT
// All orders in one call: each order once, with the bits or at least the bound of that order by itself, at the stated
// cost.
#include "core/derivative/all_orders.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/derivative/roster.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "core/operations/counting.hpp"
#include "experiments/metric/derivative_scale.hpp"

namespace bezierbench {
namespace {

template <int Dimension>
Curve<Form::bernstein, double, Dimension> random_curve(int n, Inputs& inputs) {
  Curve<Form::bernstein, double, Dimension> curve(n);
  for (int i = 0; i <= n; ++i)
    for (int axis = 0; axis < Dimension; ++axis) curve(axis, i) = inputs.symmetric();
  return curve;
}

template <class M>
class AllOrdersOf : public testing::Test {};
using Methods = testing::Types<DifferencesDeCasteljau, DifferencesHorner, TriangleDerivatives, WoznyChudyDerivatives>;
TYPED_TEST_SUITE(AllOrdersOf, Methods);

TYPED_TEST(AllOrdersOf, GivesEachOrderOnce) {
  Inputs inputs(1);
  for (const int n : {0, 1, 5})
    for (const int last_order : {0, 1, 3, 7}) {
      std::multiset<int> orders;
      TypeParam::all(random_curve<2>(n, inputs), last_order, 0.25, [&](int k, const auto&) { orders.insert(k); });
      ASSERT_EQ(orders.size(), static_cast<std::size_t>(last_order) + 1);
      for (int k = 0; k <= last_order; ++k) EXPECT_TRUE(orders.contains(k));
    }
}

/// The points of one level are shared where the weights depend on the highest order, which changes the last bits.
TYPED_TEST(AllOrdersOf, HasTheBitsOfEachOrderUnlessItSharesWeights) {
  Inputs inputs(2);
  for (const int n : {0, 1, 2, 5, 20})
    for (const double t : {inputs.unit(), 0.0, 1.0, -0.5}) {
      const auto curve = random_curve<2>(n, inputs);
      TypeParam::all(curve, n + 2, t, [&](int k, const Point<double, 2>& derivative) {
        if (!std::is_same_v<TypeParam, WoznyChudyDerivatives> || k >= n || !(t > 0 && t < 1)) {
          EXPECT_EQ(derivative, TypeParam::evaluate(TypeParam::prepare(curve, k), t)) << n << ' ' << k << ' ' << t;
        }
      });
    }
}

TYPED_TEST(AllOrdersOf, KeepsTheBoundOfEachOrder) {
  Inputs inputs(3);
  reference::ExactCurve exact;
  metric::DerivativeScale scale;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = trial % 13;
    auto curve = random_curve<1>(n, inputs);
    for (int i = 0; i <= n && trial % 3 == 0; ++i) curve(0, i) = std::ldexp(curve(0, i), -1050);  // subnormal
    const double t = trial % 4 == 0 ? 3 * inputs.symmetric() : inputs.unit();
    const CurveView<double> view{Form::bernstein, 1, n, std::span(curve.data(), static_cast<std::size_t>(n) + 1)};
    TypeParam::all(curve, trial % 5, t, [&](int k, const Point<double, 1>& derivative) {
      scale.set(view, k, t);
      const double error = reference::Distance(exact.derivative(view, k, t)).to({derivative.data(), 1});
      EXPECT_FALSE(reference::TrialScale::violates(error, scale.bound(TypeParam::bound, reference::double_arithmetic)))
          << "degree " << n << " order " << k << " of " << trial % 5 << " t " << t;
    });
  }
}

template <class M>
double counted_flops(int n, int last_order) {
  using counting::Counting;
  counting::tape = {};
  Curve<Form::bernstein, Counting, 2> curve(n);
  for (int i = 0; i <= n; ++i)
    for (int axis = 0; axis < 2; ++axis) curve(axis, i) = Counting::input(i + axis);
  M::all(curve, last_order, Counting::input(0.25), [](int, const auto&) {});
  return counting::tape.count.flops();
}

/// The formulas of `flops_of_all`, for d = 2.
TEST(AllOrders, CostsWhatTheMethodsState) {
  constexpr double d = 2;
  for (const double n : {3., 10., 20.})
    for (const double k : {0., 1., 2., 3.}) {
      const double differences = d * k * (k + 1) * (k + 2) / 6 + d * (k + 1);
      const auto flops = [&]<class M>(const M&) { return counted_flops<M>(static_cast<int>(n), static_cast<int>(k)); };
      EXPECT_EQ(flops(TriangleDerivatives()), 3 * d * n * (n + 1) / 2 + differences + 2);
      EXPECT_EQ(flops(WoznyChudyDerivatives()),
                (n - k) * (6 + 3 * d * (k + 1)) + 3 * d * k * (k + 1) / 2 + differences + 4);
      EXPECT_EQ(flops(DifferencesHorner()),
                (1 + 6 * d) * (k + 1) * (2 * n - k) / 2 + (1 + 3 * d) * (k + 1) - d * (n + 1));
    }
}

template <class M>
class Composed : public testing::Test {};
using ComposedMethods = testing::Types<DifferencesHorner, TriangleDerivatives, WoznyChudyDerivatives>;
TYPED_TEST_SUITE(Composed, ComposedMethods);

TYPED_TEST(Composed, HasTheBitsOfTheLastOrder) {
  using All = AllOrders<TypeParam>;
  EXPECT_EQ(All::info.id, "all_orders_" + std::string(TypeParam::info.id));
  Inputs inputs(4);
  for (const int n : {0, 1, 4, 12})
    for (const int order : {0, 1, 3, 5, 1023, 5000})
      for (const double t : {inputs.unit(), 0.0, 1.0, 1.5}) {
        const auto curve = random_curve<3>(n, inputs);
        EXPECT_EQ(All::evaluate(All::prepare(curve, order), t),
                  TypeParam::evaluate(TypeParam::prepare(curve, order), t))
            << n << ' ' << order << ' ' << t;
      }
}

}  // namespace
}  // namespace bezierbench
