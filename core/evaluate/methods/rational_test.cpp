// SPDX-License-Identifier: MIT
// What every method for rational curves must do with weights, beside what roster_test.cpp asks of every method.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/evaluation_test.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench {
namespace {

template <class Scalar>
std::vector<const Kernel<Scalar>*> rational_kernels(int dimension) {
  std::vector<const Kernel<Scalar>*> chosen;
  for (const auto& kernel : kernels<Scalar>(dimension))
    if (kernel.info->form == Form::rational) chosen.push_back(&kernel);
  return chosen;
}

class RationalMethod : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const Kernel<double>& kernel(int dimension = 2) const {
    return *rational_kernels<double>(dimension)[GetParam()];
  }
  [[nodiscard]] const Kernel<float>& float_kernel() const { return *rational_kernels<float>(2)[GetParam()]; }
};

// Tests of what some methods state only: each runs for those.
class BoundedRationalMethod : public RationalMethod {};      ///< states a bound
class RationalMethodOfBothForms : public RationalMethod {};  ///< and is there for polynomial curves, too

/// Positive weights over `binades` powers of two.
std::vector<double> positive_weights(Inputs& inputs, int degree, int binades) {
  std::vector<double> weights;
  for (int i = 0; i <= degree; ++i)
    weights.push_back(std::ldexp(1 + inputs.unit(), static_cast<int>(binades * (inputs.unit() - 0.5))));
  return weights;
}

/// Judges one kernel on one curve at many t; returns how many bounds there were.
template <class Scalar>
int expect_bound(const Kernel<Scalar>& kernel, int dimension, int degree, const std::vector<double>& coefficients,
                 const std::vector<double>& weights, const std::vector<double>& parameters) {
  const auto& arithmetic = sizeof(Scalar) == sizeof(float) ? reference::float_arithmetic : reference::double_arithmetic;
  const std::vector<Scalar> c(coefficients.begin(), coefficients.end());
  const std::vector<Scalar> w(weights.begin(), weights.end());
  const std::vector<Scalar> ts(parameters.begin(), parameters.end());
  const std::vector<double> true_c(c.begin(), c.end());
  const std::vector<double> true_w(w.begin(), w.end());
  const CurveView<double> curve{Form::rational, dimension, degree, true_c, true_w};
  const auto points = evaluate<Scalar>(kernel, {Form::rational, dimension, degree, c, w}, ts);
  reference::ExactCurve exact;
  reference::TrialScale scale;
  int bounded = 0;
  for (std::size_t k = 0; k < ts.size(); ++k) {
    const double t = ts[k];
    scale.set(curve, t);
    const double bound = scale.bound(*kernel.info->bound, arithmetic);
    if (!std::isfinite(bound)) continue;  // nothing is proved here
    ++bounded;
    const auto d = static_cast<std::size_t>(dimension);
    const std::vector<double> point(points.begin() + static_cast<std::ptrdiff_t>(k * d),
                                    points.begin() + static_cast<std::ptrdiff_t>((k + 1) * d));
    const double error = reference::Distance(exact.point(curve, t)).to(point);
    EXPECT_FALSE(reference::TrialScale::violates(error, bound))
        << kernel.info->id << " degree " << degree << " t " << t << " error " << error << " bound " << bound;
  }
  return bounded;
}

std::vector<double> some_parameters(Inputs& inputs) {
  std::vector<double> ts{0, 1, 0.5, 0x1p-30, 0x1p-1000, 1 - 0x1p-24, 1 - 0x1p-53};
  for (int k = 0; k < 6; ++k) ts.push_back(inputs.unit());
  return ts;
}

TEST_P(BoundedRationalMethod, KeepsItsBoundWithWildWeights) {
  Inputs inputs(21);
  int bounded = 0;
  for (const int dimension : {1, 2, 3})
    for (const int degree : {0, 1, 2, 3, 5, 8, 13, 20, 34, 60, 120}) {
      if (!kernel(dimension).info->supports<double>(degree)) continue;
      for (int repeat = 0; repeat < 10; ++repeat) {
        const auto c = inputs.coefficients(degree, dimension);
        bounded += expect_bound(kernel(dimension), dimension, degree, c, positive_weights(inputs, degree, 120),
                                some_parameters(inputs));
      }
    }
  EXPECT_GT(bounded, 2000);
}

TEST_P(BoundedRationalMethod, KeepsItsBoundWithWildWeightsInFloat) {
  Inputs inputs(22);
  int bounded = 0;
  for (const int degree : {0, 1, 2, 3, 5, 8, 20, 34})
    for (int repeat = 0; repeat < 30; ++repeat)
      bounded += expect_bound(float_kernel(), 2, degree, inputs.coefficients(degree, 2),
                              positive_weights(inputs, degree, 40), some_parameters(inputs));
  EXPECT_GT(bounded, 1000);
}

/// Weights and points whose products, sums and quotients are subnormal, or nearly.
TEST_P(BoundedRationalMethod, KeepsItsBoundWhereItUnderflows) {
  Inputs inputs(23);
  int bounded = 0;
  for (const int of_points : {0, -500, -1000, -1060})
    for (const int of_weights : {500, 0, -500, -960, -1015, -1060})
      for (const int degree : {0, 1, 2, 5, 20}) {
        auto c = inputs.coefficients(degree, 1);
        for (double& value : c) value = std::ldexp(value, of_points);
        for (const int binades : {0, 20, 120, 700}) {
          auto w = positive_weights(inputs, degree, binades);
          for (double& value : w) value = std::ldexp(value, of_weights);
          bounded += expect_bound(kernel(1), 1, degree, c, w, some_parameters(inputs));
        }
      }
  EXPECT_GT(bounded, 1000);
}

/// Weights of 0 are weights: a method that does not need positive ones keeps its bound with them.
TEST_P(BoundedRationalMethod, KeepsItsBoundWithWeightsOfZero) {
  Inputs inputs(24);
  int bounded = 0;
  for (const int degree : {1, 2, 3, 8, 20})
    for (int repeat = 0; repeat < 20; ++repeat) {
      auto w = positive_weights(inputs, degree, 20);
      w[static_cast<std::size_t>(repeat % (degree + 1))] = 0;
      if (degree > 3) w[3] = w[4] = 0;
      bounded += expect_bound(kernel(), 2, degree, inputs.coefficients(degree, 2), w, some_parameters(inputs));
    }
  if (kernel().info->bound->positive_weights_only)
    EXPECT_EQ(bounded, 0);
  else
    EXPECT_GT(bounded, 1000);
}

/// Where the denominator may cancel nothing is proved.
TEST_P(BoundedRationalMethod, StatesNoBoundWhereWeightsMayCancel) {
  const std::vector<double> c{1, 2, 3};
  const std::vector<double> positive{1, 2, 1};
  const std::vector<double> mixed{1, -0.5, 1};
  reference::TrialScale scale;
  const auto bound = [&](const std::vector<double>& weights, double t) {
    scale.set({Form::rational, 1, 2, c, weights}, t);
    return scale.bound(*kernel().info->bound, reference::double_arithmetic);
  };
  EXPECT_TRUE(std::isfinite(bound(positive, 0.5)));
  for (const double t : {-0.25, 1.5}) EXPECT_TRUE(std::isinf(bound(positive, t)));
  EXPECT_TRUE(std::isinf(bound(mixed, 0.5)));
}

TEST_P(RationalMethod, CommonFactorOfTheWeightsChangesNoBit) {
  Inputs inputs(25);
  for (const int degree : {0, 1, 3, 8, 20}) {
    const auto c = inputs.coefficients(degree, 2);
    const auto w = positive_weights(inputs, degree, 30);
    const auto ts = some_parameters(inputs);
    const auto points = evaluate<double>(kernel(), {Form::rational, 2, degree, c, w}, ts);
    for (const double factor : {0x1p-300, 0.5, 0x1p+40, 0x1p+300}) {
      auto scaled = w;
      for (double& value : scaled) value *= factor;
      EXPECT_EQ(evaluate<double>(kernel(), {Form::rational, 2, degree, c, scaled}, ts), points)
          << "degree " << degree << " factor " << factor;
    }
  }
}

/// With equal weights the curve is the polynomial one: the method of the same id is as near as both bounds allow.
TEST_P(RationalMethodOfBothForms, EqualWeightsGiveThePolynomialCurve) {
  const auto* polynomial = find_kernel<double>(kernel().info->id, Form::bernstein, 2);
  Inputs inputs(26);
  reference::TrialScale scale;
  for (const int degree : {0, 1, 2, 5, 20}) {
    const auto c = inputs.coefficients(degree, 2);
    const std::vector<double> ones(static_cast<std::size_t>(degree) + 1, 1.0);
    const CurveView<double> rational{Form::rational, 2, degree, c, ones};
    const CurveView<double> plain{Form::bernstein, 2, degree, c};
    for (const double t : some_parameters(inputs)) {
      scale.set(rational, t);
      const double of_rational = scale.bound(*kernel().info->bound, reference::double_arithmetic);
      scale.set(plain, t);
      const double of_plain = scale.bound(*polynomial->info->bound, reference::double_arithmetic);
      const auto p = evaluate<double>(kernel(), rational, {t});
      const auto q = evaluate<double>(*polynomial, plain, {t});
      EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1]), (of_rational + of_plain) * (1 + 0x1p-20));
    }
  }
}

/// w b / w rounds twice; a method without such products passes through its end points exactly.
TEST_P(BoundedRationalMethod, InterpolatesEndPoints) {
  Inputs inputs(27);
  const double roundings = kernel().info->bound->positive_weights_only ? 0 : 2;
  for (const int degree : {1, 2, 7, 20, 90}) {
    const auto c = inputs.coefficients(degree, 1);
    const auto w = positive_weights(inputs, degree, 60);
    const auto points = evaluate<double>(kernel(1), {Form::rational, 1, degree, c, w}, {0, 1});
    EXPECT_LE(std::abs(points[0] - c.front()), roundings * 0x1p-53 * (1 + 0x1p-50) * std::abs(c.front()));
    EXPECT_LE(std::abs(points[1] - c.back()), roundings * 0x1p-53 * (1 + 0x1p-50) * std::abs(c.back()));
  }
}

/// What rounding may change between two evaluations of curves in [-1, 1] with mild weights and low degree.
double tolerance(int degree) { return 256 * 0x1p-53 * std::pow(3, degree); }

/// A method without a bound in p~ may err in proportion to the largest weight, as barycentric forms do.
double allowance(const MethodInfo& info, int degree, const std::vector<double>& weights, double t) {
  if (info.bound) return 1;
  reference::ExactCurve exact;
  const auto& sum = exact.point({Form::bernstein, 1, degree, weights}, t);
  return *std::ranges::max_element(weights) / reference::round_to(reference::binary64, sum.coordinate(0));
}

TEST_P(RationalMethod, ReproducesConstantsWhateverTheWeights) {
  Inputs inputs(28);
  for (const int degree : {0, 1, 3, 6}) {
    const std::vector<double> c(static_cast<std::size_t>(degree) + 1, 0.7);
    const auto w = positive_weights(inputs, degree, 120);
    for (const double t : some_parameters(inputs))
      EXPECT_NEAR(evaluate<double>(kernel(1), {Form::rational, 1, degree, c, w}, {t})[0], 0.7,
                  tolerance(degree) * allowance(*kernel().info, degree, w, t));
  }
}

TEST_P(RationalMethod, ReversesWithItsPointsAndWeights) {
  Inputs inputs(29);
  for (const int degree : {1, 2, 3, 6}) {
    const auto c = inputs.coefficients(degree, 1);
    const auto w = positive_weights(inputs, degree, 4);
    const std::vector<double> c_reversed(c.rbegin(), c.rend());
    const std::vector<double> w_reversed(w.rbegin(), w.rend());
    for (const double t : {0.0, 0.125, 0.5, 0.8125})  // 1 - t is exact
      EXPECT_NEAR(evaluate<double>(kernel(1), {Form::rational, 1, degree, c, w}, {t})[0],
                  evaluate<double>(kernel(1), {Form::rational, 1, degree, c_reversed, w_reversed}, {1 - t})[0],
                  tolerance(degree));
  }
}

/// An affine map of the points is one of the curve, whatever the weights.
TEST_P(RationalMethod, IsAffinelyInvariantWithWildWeights) {
  Inputs inputs(30);
  for (const int degree : {1, 2, 5}) {
    const auto c = inputs.coefficients(degree, 2);
    const auto w = positive_weights(inputs, degree, 60);
    std::vector<double> image(c.size());
    for (std::size_t k = 0; k < c.size(); k += 2) {
      image[k] = 2 * c[k] - c[k + 1] + 1;
      image[k + 1] = 0.5 * c[k] + c[k + 1] - 1;
    }
    for (const double t : some_parameters(inputs)) {
      const auto p = evaluate<double>(kernel(), {Form::rational, 2, degree, c, w}, {t});
      const auto q = evaluate<double>(kernel(), {Form::rational, 2, degree, image, w}, {t});
      const double rounding = 4 * tolerance(degree) * allowance(*kernel().info, degree, w, t);
      EXPECT_NEAR(q[0], 2 * p[0] - p[1] + 1, rounding);
      EXPECT_NEAR(q[1], 0.5 * p[0] + p[1] - 1, rounding);
    }
  }
}

/// The quarter circle ((1-t^2)/(1+t^2), 2t/(1+t^2)): [Farin 2002] (conics), control
/// points (1,0) (1,1) (0,1) with weights 1, 1, 2; at 1/2 the Pythagorean 3-4-5, at 1/4 8-15-17, at 3/4 7-24-25.
TEST_P(RationalMethod, RunsAroundTheCircle) {
  const std::vector<double> c{1, 0, 1, 1, 0, 1};
  const std::vector<double> w{1, 1, 2};
  const auto points = evaluate<double>(kernel(), {Form::rational, 2, 2, c, w}, {0, 0.25, 0.5, 0.75, 1});
  const std::vector<double> expected{1, 0, 15 / 17.0, 8 / 17.0, 0.6, 0.8, 7 / 25.0, 24 / 25.0, 0, 1};
  EXPECT_THAT(points, testing::Pointwise(testing::DoubleNear(16 * 0x1p-53), expected));
}

/// Where among them those are of which this holds.
auto rational_methods_that(bool (*holds)(const MethodInfo& info)) {
  std::vector<std::size_t> places;
  const auto all = rational_kernels<double>(2);
  for (std::size_t place = 0; place < all.size(); ++place)
    if (holds(*all[place]->info)) places.push_back(place);
  return testing::ValuesIn(places);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& parameter) {
  return std::string(rational_kernels<double>(2)[parameter.param]->info->id);
}

bool is_any(const MethodInfo& /*info*/) { return true; }
bool is_bounded(const MethodInfo& info) { return info.bound.has_value(); }
bool is_of_both_forms(const MethodInfo& info) {
  return is_bounded(info) && find_kernel<double>(info.id, Form::bernstein, 2) != nullptr;
}

INSTANTIATE_TEST_SUITE_P(Roster, RationalMethod, rational_methods_that(is_any), name_of);
INSTANTIATE_TEST_SUITE_P(Roster, BoundedRationalMethod, rational_methods_that(is_bounded), name_of);
INSTANTIATE_TEST_SUITE_P(Roster, RationalMethodOfBothForms, rational_methods_that(is_of_both_forms), name_of);

}  // namespace
}  // namespace bezierbench
