// SPDX-License-Identifier: MIT
#include "experiments/requirements/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/metric/trial_scale.hpp"
#include "experiments/requirements/parameters.hpp"
#include "experiments/requirements/seeded_curves.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::requirements {
namespace {

template <class Scalar>
constexpr auto arithmetic_of = sizeof(Scalar) == sizeof(float) ? metric::float_arithmetic : metric::double_arithmetic;

template <class To, class From>
std::vector<To> converted(const std::vector<From>& values) {
  return {values.begin(), values.end()};
}

/// Holds points of one method to its bound.
class BoundedPoints {
 public:
  explicit BoundedPoints(const MethodInfo& info) : info_(info) {}

  /// At every t, which are rounded to Scalar like the coefficients.
  template <class Scalar>
  void judge(const Kernel<Scalar>& kernel, int degree, const std::vector<double>& coefficients,
             const std::vector<double>& ts) {
    const auto rounded = converted<Scalar>(coefficients);
    const auto at = converted<Scalar>(ts);
    const auto given = converted<double>(rounded);
    const auto curve = view(kernel.info->form, kernel.dimension, degree, given);
    const auto points =
        converted<double>(evaluate<Scalar>(kernel, view(kernel.info->form, kernel.dimension, degree, rounded), at));
    const auto d = static_cast<std::size_t>(kernel.dimension);
    for (std::size_t k = 0; k < at.size(); ++k)
      judge(curve, at[k], std::span(points).subspan(k * d, d), arithmetic_of<Scalar>);
  }

  /// Where the bound is infinite nothing is tested, so at least one case of `of` must have a finite one.
  [[nodiscard]] Outcome outcome(std::size_t of) {
    outcome_.expect(of * bounded_ >= outcome_.cases(),
                    [&] { return fmt::format("only {} of these cases have a finite bound", bounded_); });
    return outcome_;
  }

 private:
  void judge(const CurveView<double>& curve, double t, std::span<const double> point,
             const metric::Arithmetic& arithmetic) {
    scale_.set(curve, t);
    const double error = reference::Distance(exact_.point(curve, t)).to(point);
    const double bound = scale_.bound(*info_.bound, arithmetic);
    bounded_ += std::isfinite(bound) ? 1 : 0;
    outcome_.expect(!metric::TrialScale::violates(error, bound), [&] {
      return fmt::format("degree {}, {} axes, t {}: error {}, bound {}", curve.degree, curve.dimension, t, error,
                         bound);
    });
  }

  const MethodInfo& info_;
  reference::ExactCurve exact_;
  metric::TrialScale scale_;
  std::size_t bounded_ = 0;
  Outcome outcome_;
};

/// `count` further parameters in [0, 1].
std::vector<double> with_random(std::vector<double> ts, Inputs& inputs, int count) {
  for (int k = 0; k < count; ++k) ts.push_back(inputs.unit());
  return ts;
}

/// Points of curves whose coordinates are all 1, 1 and -1 in turn, and 0 but for a 1 in the middle.
template <class Scalar>
void expect_numbers(const Kernel<Scalar>& kernel, int degree, Outcome& outcome) {
  const auto d = static_cast<std::size_t>(kernel.dimension);
  const std::size_t count = (static_cast<std::size_t>(degree) + 1) * d;
  std::vector<Scalar> ones(count, Scalar(1));
  auto signs = ones;
  std::vector<Scalar> one(count, Scalar(0));
  for (std::size_t i = 0; i < count; ++i) {
    if (i / d % 2 != 0) signs[i] = Scalar(-1);
    if (i / d == count / d / 2) one[i] = Scalar(1);
  }
  const std::vector<Scalar> ts{Scalar(0), Scalar(0.5), Scalar(1)};
  for (const auto& coefficients : {ones, signs, one}) {
    const auto points = evaluate<Scalar>(kernel, view(kernel.info->form, kernel.dimension, degree, coefficients), ts);
    for (std::size_t k = 0; k < points.size(); ++k)
      outcome.expect(std::isfinite(points[k]), [&] {
        return fmt::format("degree {}, {} bytes, points {}, {}, ..., t {}: {}", degree, sizeof(Scalar),
                           coefficients.front(), coefficients.back(), ts[k / d], points[k]);
      });
  }
}

}  // namespace

Outcome keeps_its_bound(const Evaluator& method) {
  Inputs inputs(1);
  BoundedPoints judge(method.info());
  for (const int dimension : {1, 2, 3})
    for (const int degree : degrees_for(method.info(), {0, 1, 2, 3, 5, 8, 13, 20, 34, 60, 120})) {
      for (int repeat = 0; repeat < 20; ++repeat) {
        auto coefficients = inputs.coefficients(degree, dimension);
        if (repeat % 4 == 3)  // magnitudes from 2^-40 to 2^40 side by side
          for (double& value : coefficients) value = std::ldexp(value, static_cast<int>(80 * inputs.symmetric() / 2));
        judge.judge(method.kernel(dimension), degree, coefficients, with_random(parameters(), inputs, 8));
      }
    }
  return judge.outcome(2);
}

Outcome keeps_its_bound_in_float(const Evaluator& method) {
  Inputs inputs(2);
  BoundedPoints judge(method.info());
  for (const int degree : degrees_for<float>(*method.in_float->info, {0, 1, 2, 3, 8, 20, 34})) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto coefficients = inputs.coefficients(degree, 2);
      judge.judge(*method.in_float, degree, coefficients, {inputs.unit()});
    }
  }
  return judge.outcome(2);
}

Outcome keeps_its_bound_where_it_underflows(const Evaluator& method) {
  Inputs inputs(10);
  BoundedPoints judge(method.info());
  for (const int exponent : {-900, -960, -1020, -1060, -1070})
    for (const int degree : degrees_for(method.info(), {0, 1, 2, 5, 20, 34})) {
      for (int repeat = 0; repeat < 10; ++repeat) {
        auto coefficients = inputs.coefficients(degree, 1);
        for (double& value : coefficients) value = std::ldexp(value, exponent);
        judge.judge(method.kernel(1), degree, coefficients, with_random(parameters(), inputs, 4));
      }
    }
  return judge.outcome(2);
}

Outcome keeps_its_bound_up_to_overflow(const Evaluator& method) {
  Inputs inputs(11);
  BoundedPoints judge(method.info());
  const auto huge = [&inputs](int degree, int dimension, int exponent) {
    auto coefficients = inputs.coefficients(degree, dimension);
    for (double& value : coefficients) value = std::ldexp(std::copysign(1 - 0x1p-20, value), exponent);
    return coefficients;
  };
  for (const int below : {120, 60, 40, 20, 10, 5, 4, 3, 2, 1, 0}) {
    for (const int degree : degrees_for(method.info(), {1, 2, 5, 20, 34, 60}))
      judge.judge(method.kernel(1), degree, huge(degree, 1, 1024 - below), parameters());
    for (const int degree : degrees_for<float>(*method.in_float->info, {1, 2, 5, 20, 34}))
      judge.judge(*method.in_float, degree, huge(degree, 2, 128 - below), parameters());
  }
  return judge.outcome(6);  // by way of forward_substitution, and in [0, 1] only, few are left
}

Outcome works_up_to_its_largest_degree(const Evaluator& method) {
  // Exact conversions to Bernstein form take a second for each curve of degree 1023.
  const int most = method.info().prepare_exponent > 4 ? 300 : max_degree;
  Outcome outcome;
  expect_numbers(method.kernel(1), std::min(most, method.info().max_degree), outcome);
  expect_numbers(*method.in_float, std::min(most, method.info().max_degree_float), outcome);
  return outcome;
}

Outcome is_right_on_mild_curves(const Evaluator& method) {
  Inputs inputs(3);
  reference::ExactCurve exact;
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {0, 1, 2, 3, 4, 6}))
    for (int repeat = 0; repeat < 50; ++repeat) {
      const auto coefficients = inputs.coefficients(degree, 2);
      const auto curve = view(method.info().form, 2, degree, coefficients);
      const double t = inputs.unit();
      const double error = reference::Distance(exact.point(curve, t)).to(evaluate(method.kernel(2), curve, {t}));
      outcome.expect(error <= 64 * 0x1p-53 * std::pow(3, degree),
                     [&] { return fmt::format("degree {}, t {}: error {}", degree, t, error); });
    }
  return outcome;
}

}  // namespace bezierbench::requirements
