// SPDX-License-Identifier: MIT
// Properties of every method for derivatives, then the bounds on random and on difficult curves.
#include "core/derivative/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/derivative/kernel.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "experiments/metric/derivative_scale.hpp"

namespace bezierbench {
namespace {

constexpr std::string_view as_printed = Seed000::info.id;

std::vector<double> derivative(const DerivativeKernel& kernel, const CurveView<double>& curve, int order, double t) {
  std::vector<double> point(static_cast<std::size_t>(curve.dimension));
  kernel.derivative(curve, order, t, point.data());
  return point;
}

/// The methods for this form, except those that are wrong at this order.
std::vector<DerivativeKernel> right_kernels(Form form, int dimension, int order) {
  std::vector<DerivativeKernel> kernels;
  for (const auto& kernel : derivative_kernels(dimension))
    if (kernel.info->form == form && (order <= 1 || kernel.info->id != as_printed)) kernels.push_back(kernel);
  return kernels;
}

/// The worked example of [Document 000] (section 2.2): the control points of the hodographs are printed there.
const std::vector<double> worked{1, 1, 3, 1, 4, 2, 6, 3};
const std::vector<double> worked_in_powers{1, 1, 6, 0, -3, 3, 2, -1};

struct WorkedDerivative {
  int order;
  double t;
  std::vector<double> value;
};
const std::vector<WorkedDerivative> worked_derivatives{
    {1, 0, {6, 0}}, {1, 0.5, {4.5, 2.25}}, {1, 1, {6, 3}},   {2, 0, {-6, 6}},      {2, 0.5, {0, 3}},
    {2, 1, {6, 0}}, {3, 0.5, {12, -6}},    {4, 0.5, {0, 0}}, {1023, 0.25, {0, 0}}, {0, 0, {1, 1}},
};

TEST(Derivative, GivesTheWorkedExampleExactly) {
  for (const auto& [order, t, value] : worked_derivatives)
    for (const Form form : {Form::bernstein, Form::power})
      for (const auto& kernel : right_kernels(form, 2, order))
        EXPECT_EQ(derivative(kernel, {form, 2, 3, form == Form::power ? worked_in_powers : worked}, order, t), value)
            << kernel.info->id << " order " << order << " t " << t;
}

TEST(Derivative, TheSeedDocumentAsPrintedIsWrongFromTheSecondOrderOn) {
  const auto& seed = derivative_kernels(2).back();
  ASSERT_EQ(seed.info->id, as_printed);
  EXPECT_EQ(seed.bound, nullptr);
  const CurveView<double> curve{Form::bernstein, 2, 3, worked};
  EXPECT_THAT(derivative(seed, curve, 1, 0.5), testing::ElementsAre(4.5, 2.25));
  EXPECT_THAT(derivative(seed, curve, 2, 0.5), testing::ElementsAre(6, 6));
  EXPECT_THAT(derivative(seed, curve, 3, 0.5), testing::ElementsAre(12, 0));
}

/// [Document 000], eq. (7): B'_i,n = n (B_(i-1),(n-1) - B_i,(n-1)), from the products of powers at t = 1/4, which are
/// exact.
TEST(SourceDocument, DerivativeOfABernsteinPolynomial) {
  const auto polynomial = [](int i, int n) {
    return i < 0 || i > n ? 0 : BinomialRow<double, dynamic>(n)[i] * std::pow(0.25, i) * std::pow(0.75, n - i);
  };
  for (const int n : {1, 2, 3, 7})
    for (int i = 0; i <= n; ++i) {
      std::vector<double> unit(static_cast<std::size_t>(n) + 1, 0.0);
      unit[static_cast<std::size_t>(i)] = 1;
      for (const auto& kernel : right_kernels(Form::bernstein, 1, 1))
        EXPECT_NEAR(derivative(kernel, {Form::bernstein, 1, n, unit}, 1, 0.25)[0],
                    n * (polynomial(i - 1, n - 1) - polynomial(i, n - 1)), 1e-14)
            << kernel.info->id << " " << i << " of " << n;
    }
}

/// [Document 000], eq. (11), sums the points of the second derivative with Bernstein polynomials of degree n - 1. These
/// are 1/4 and 1/2 at t = 1/2, and those of degree n - 2 are 1/2. Likewise the points of eq. (9) have the factor n that
/// eq. (6) has before its sum: together they count it twice.
TEST(SourceDocument, PrintedSecondDerivativeIsOfTheWrongDegree) {
  Curve<Form::bernstein, double, 2> curve(3);
  for (int i = 0; i <= 3; ++i)
    for (int axis = 0; axis < 2; ++axis) curve(axis, i) = worked[static_cast<std::size_t>(2 * i + axis)];
  const auto points = hodograph(curve, 2);
  std::vector<double> right;
  std::vector<double> printed;
  for (int axis = 0; axis < 2; ++axis) {
    right.push_back((points(axis, 0) + points(axis, 1)) / 2);
    printed.push_back(points(axis, 0) / 4 + points(axis, 1) / 2);
  }
  EXPECT_THAT(right, testing::ElementsAre(0, 3));
  EXPECT_THAT(printed, testing::ElementsAre(1.5, 1.5));
  const auto first = hodograph(curve, 1);
  EXPECT_EQ(3 * (first(0, 0) + 2 * first(0, 1) + first(0, 2)) / 4, 3 * 4.5);  // (6) with the points of (9)
}

/// 20 19 ... 13 = 5079110400 becomes 784143104 in 32 bits. D^8 b_0 = b_0 where all other control points are 0.
TEST(Derivative, TheFactorOfTheSeedDocumentWrapsAround) {
  std::vector<double> first(21, 0.0);
  first[0] = 1;
  const CurveView<double> curve{Form::bernstein, 1, 20, first};
  EXPECT_EQ(derivative(derivative_kernels(1).back(), curve, 8, 0)[0], 784143104);
  EXPECT_EQ(derivative(derivative_kernels(1).front(), curve, 8, 0)[0], 5079110400);
}

/// Curves on which differences or evaluators lose digits or range.
std::vector<double> nasty(int kind, int n, int d, Inputs& inputs) {
  auto c = inputs.coefficients(n, d);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto point = static_cast<double>(i / static_cast<std::size_t>(d));
    switch (kind) {
      case 0: break;                                                                      // random
      case 1: c[i] = 1 + 0x1p-45 * c[i]; break;                                           // all points close together
      case 2: c[i] = std::ldexp(c[i], static_cast<int>(inputs.unit() * 80) - 40); break;  // sizes far apart
      case 3: c[i] *= 0x1p-1060; break;                                                   // subnormal
      case 4: c[i] *= 0x1p+800; break;                                                    // huge
      case 5: c[i] = 0.1; break;                                                          // all points equal
      case 6: c[i] = 0.1 + 0.3 * point; break;                                            // equally spaced on a line
      case 7: c[i] = static_cast<int>(point) % 2 == 0 ? 0.1 : -0.1; break;                // doubling back
      case 8: c[i] = point * point * 0x1p-10 + c[i] * 0x1p-50; break;  // smooth, so differences cancel
      default: c[i] = std::floor(c[i] * 9); break;                     // small integers
    }
  }
  return c;
}
constexpr int nasty_kinds = 10;

double nasty_t(int trial, Inputs& inputs) {
  switch (trial % 8) {
    case 0: return 0;
    case 1: return 1;
    case 2: return inputs.unit() * 0x1p-60;
    case 3: return 1 - inputs.unit() * 0x1p-40;
    case 4: return 3 * inputs.symmetric();
    default: return inputs.unit();
  }
}

/// Points close together have an A far above their derivatives, which costs other methods up to 30 bits.
TEST(Derivative, CompensationKeepsAllDigits) {
  Inputs inputs(11);
  reference::ExactCurve exact;
  int lost_by_others = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int n = 1 + trial % 15;
    const int order = trial % 4;
    const Form form = trial % 3 == 0 ? Form::power : Form::bernstein;
    auto c = inputs.coefficients(n, 1);
    if (form == Form::bernstein)
      for (double& value : c) value = 1 + 0x1p-30 * value;
    const double t = inputs.unit();
    const CurveView<double> curve{form, 1, n, c};
    const reference::Distance distance(exact.derivative(curve, order, t));
    const double truth = std::abs(distance.to_origin(1));
    metric::DerivativeScale scale;
    scale.set(curve, order, t);
    if (!(truth > 0x1p-8 * scale.p_tilde())) continue;
    for (const auto& kernel : right_kernels(form, 1, order)) {
      const double error = distance.to(derivative(kernel, curve, order, t));
      if (kernel.info->id.starts_with("compensated"))
        EXPECT_LE(error, 0x1.01p-53 * truth) << kernel.info->id << " degree " << n << " order " << order << " t " << t;
      else if (error > 0x1p-45 * truth)
        ++lost_by_others;
    }
  }
  EXPECT_GT(lost_by_others, 500);
}

/// 1,000 curves of each kind, each at orders from 0 to beyond the degree, by every method with a bound. A third of the
/// weights of rational curves have both signs.
TEST(Derivative, KeepsItsBoundOnRandomAndNastyCurves) {
  Inputs inputs(10);
  reference::ExactCurve exact;
  metric::DerivativeScale scale;
  int judged = 0;
  int violations = 0;
  for (int trial = 0; trial < 1000 * nasty_kinds; ++trial) {
    const int d = 1 + trial % 3;
    const int n = static_cast<int>(inputs.unit() * (trial % 50 == 0 ? 70 : 12));
    const int order = static_cast<int>(inputs.unit() * (n + 2));
    const Form form = std::array{Form::power, Form::bernstein, Form::bernstein, Form::rational}[trial / 2 % 4];
    const auto c = nasty(trial % nasty_kinds, n, d, inputs);
    const double t = nasty_t(trial / nasty_kinds, inputs);
    std::vector<double> weights;
    for (int i = 0; i <= n && form == Form::rational; ++i)
      weights.push_back((trial % 3 == 0 ? inputs.symmetric() : inputs.unit()) * std::ldexp(1, trial % 9));
    const CurveView<double> curve{form, d, n, c, weights};
    const auto& truth = exact.derivative(curve, order, t);
    if (!truth.exists()) continue;
    scale.set(curve, order, t);
    const reference::Distance distance(truth);
    for (const auto& kernel : derivative_kernels(d)) {
      if (kernel.info->form != form || kernel.bound == nullptr) continue;
      const double bound = scale.bound(*kernel.bound, reference::double_arithmetic);
      const double error = distance.to(derivative(kernel, curve, order, t));
      if (!std::isfinite(bound) || !std::isfinite(error)) continue;
      ++judged;
      if (!reference::TrialScale::violates(error, bound)) continue;
      ++violations;
      ADD_FAILURE() << kernel.info->id << " trial " << trial << " degree " << n << " order " << order << " t " << t
                    << ": error " << error << ", bound " << bound;
      ASSERT_LT(violations, 5);
    }
  }
  EXPECT_GT(judged, 22000);  // all but those that overflow
}

/// A circle about (5, 0), t = tan(phi / 2): C' = 2 / (1 + t^2) (-sin phi, cos phi), here at tan = 3/4.
TEST(Derivative, OfACircleIsItsTangent) {
  const std::vector<double> points{6, 0, 6, 1, 5, 1};
  const std::vector<double> weights{1, 1, 2};
  const CurveView<double> circle{Form::rational, 2, 2, points, weights};
  for (const auto& kernel : right_kernels(Form::rational, 2, 1)) {
    const auto tangent = derivative(kernel, circle, 1, 0.75);
    EXPECT_NEAR(tangent[0], -1.28 * 0.96, 1e-14) << kernel.info->id;
    EXPECT_NEAR(tangent[1], 1.28 * 0.28, 1e-14) << kernel.info->id;
    EXPECT_TRUE(std::isnan(derivative(kernel, circle, max_degree + 1, 0.75)[0]));
  }
}

/// 1e6 times their size away from the origin A'' and W'' C cancel, by about 20 bits; about the nearer end they do not.
TEST(Derivative, AboutTheNearerEndNothingIsLostFarFromTheOrigin) {
  Inputs inputs(12);
  reference::ExactCurve exact;
  double largest_of_local = 0;
  double largest_of_others = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 2 + trial % 4;
    auto c = inputs.coefficients(n, 2);
    for (double& value : c) value = 0x1p+20 + std::ldexp(std::floor(std::ldexp(value, 20)), -20);
    std::vector<double> weights;
    for (int i = 0; i <= n; ++i) weights.push_back(0.5 + inputs.unit());
    const CurveView<double> curve{Form::rational, 2, n, c, weights};
    const double t = inputs.unit();
    const reference::Distance distance(exact.derivative(curve, 2, t));
    for (const auto& kernel : right_kernels(Form::rational, 2, 2)) {
      const double error = distance.to(derivative(kernel, curve, 2, t));
      double& largest = kernel.info->id.starts_with("local:") ? largest_of_local : largest_of_others;
      largest = std::max(largest, error);
    }
  }
  EXPECT_LT(largest_of_local, 1e-11);
  EXPECT_GT(largest_of_others, 1000 * largest_of_local);
}

}  // namespace
}  // namespace bezierbench
