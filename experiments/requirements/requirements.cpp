// SPDX-License-Identifier: MIT
#include "experiments/requirements/requirements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/requirements/seeded_curves.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::requirements {
namespace {

template <class Scalar>
constexpr auto arithmetic_of = sizeof(Scalar) == sizeof(float) ? reference::float_arithmetic
                                                               : reference::double_arithmetic;

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
             const reference::Arithmetic& arithmetic) {
    scale_.set(curve, t);
    const double error = reference::Distance(exact_.point(curve, t)).to(point);
    const double bound = scale_.least_bound(*info_.bound, arithmetic);
    bounded_ += std::isfinite(bound) ? 1 : 0;
    outcome_.expect(!reference::TrialScale::violates(error, bound), [&] {
      return fmt::format("degree {}, {} axes, t {}: error {}, bound {}", curve.degree, curve.dimension, t, error,
                         bound);
    });
  }

  const MethodInfo& info_;
  reference::ExactCurve exact_;
  reference::TrialScale scale_;
  std::size_t bounded_ = 0;
  Outcome outcome_;
};

/// `count` further parameters in [0, 1].
std::vector<double> with_random(std::vector<double> ts, Inputs& inputs, int count) {
  for (int k = 0; k < count; ++k) ts.push_back(inputs.unit());
  return ts;
}

/// Points of curves whose coordinates are all 1, 1 and -1 in turn, and 0 except for a 1 in the middle.
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

// Methods without a bound must not be asked for the first four.

Outcome keeps_its_bound(const Evaluator& method) {
  Inputs inputs(1);
  BoundedPoints judge(method.info());
  for (const int dimension : {1, 2, 3})
    for (const int degree : degrees_for(method.info(), {0, 1, 2, 3, 5, 8, 13, 20, 34, 60, 120})) {
      for (int repeat = 0; repeat < 20; ++repeat) {
        auto coefficients = inputs.coefficients(degree, dimension);
        if (repeat % 4 == 3)  // magnitudes from 2^-40 to 2^40 side by side
          for (double& value : coefficients) value = std::ldexp(value, static_cast<int>(80 * inputs.symmetric() / 2));
        if (repeat % 4 == 2)  // up to 2^20 times as far from the origin as from each other
          for (double& value : coefficients) value += std::ldexp(1, repeat + 2);
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
      auto coefficients = inputs.coefficients(degree, 2);
      if (repeat % 2 == 1)
        for (double& value : coefficients) value += repeat;
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

/// An error that is infinite, because a result overflows, is beyond every finite bound.
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

/// The declared degrees are those at which coordinates of at most 1 give numbers.
Outcome works_up_to_its_largest_degree(const Evaluator& method) {
  // Exact conversions to Bernstein form take a second for each curve of degree 1023.
  const int most = method.info().prepare_exponent > 4 ? 300 : max_degree;
  Outcome outcome;
  expect_numbers(method.kernel(1), std::min(most, method.info().max_degree), outcome);
  expect_numbers(*method.in_float, std::min(most, method.info().max_degree_float), outcome);
  return outcome;
}

/// Even a method without a bound is accurate to first order where nothing is amplified much.
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

/// What rounding may change in a relation between two evaluations of curves in [-4, 4] of low degree.
double tolerance(int degree) { return 4 * 256 * 0x1p-53 * std::pow(3, degree); }

void expect_near(Outcome& outcome, double found, double expected, double tolerance, int degree, double t) {
  outcome.expect(std::abs(found - expected) <= tolerance,
                 [&] { return fmt::format("degree {}, t {}: {} instead of {}", degree, t, found, expected); });
}

void expect_same(Outcome& outcome, double found, double expected, int degree, double t) {
  outcome.expect(found == expected,
                 [&] { return fmt::format("degree {}, t {}: {} instead of {}", degree, t, found, expected); });
}

Outcome reproduces_constants(const Evaluator& method) {
  const auto ts = parameters_for(method.info());
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {0, 1, 3, 6})) {
    std::vector<double> coefficients(static_cast<std::size_t>(2 * degree) + 2, 0);
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      if (method.info().form != Form::power || k < 2) coefficients[k] = k % 2 == 0 ? 0.7 : -1.3;
    const auto points = evaluate(method.kernel(2), view(method.info().form, 2, degree, coefficients), ts);
    for (std::size_t k = 0; k < ts.size(); ++k) {
      const double outside = std::pow(std::abs(ts[k]) + std::abs(1 - ts[k]), degree);
      expect_near(outcome, points[2 * k], 0.7, tolerance(degree) * outside, degree, ts[k]);
      expect_near(outcome, points[2 * k + 1], -1.3, tolerance(degree) * outside, degree, ts[k]);
    }
  }
  return outcome;
}

Outcome is_affinely_invariant(const Evaluator& method) {
  Inputs inputs(8);
  Outcome outcome;
  const auto form = method.info().form;
  const bool points = form != Form::power;  // in power form only q_0 is moved by a translation
  for (const int degree : degrees_for(method.info(), {0, 1, 2, 5})) {
    const auto c = inputs.coefficients(degree, 2);
    std::vector<double> image(c.size());
    for (std::size_t k = 0; k < c.size(); k += 2) {
      const double moved = points || k == 0 ? 1 : 0;
      image[k] = 2 * c[k] - c[k + 1] + moved;
      image[k + 1] = 0.5 * c[k] + c[k + 1] - moved;
    }
    const double t = inputs.unit();
    const auto p = evaluate(method.kernel(2), view(form, 2, degree, c), {t});
    const auto q = evaluate(method.kernel(2), view(form, 2, degree, image), {t});
    expect_near(outcome, q[0], 2 * p[0] - p[1] + 1, tolerance(degree), degree, t);
    expect_near(outcome, q[1], 0.5 * p[0] + p[1] - 1, tolerance(degree), degree, t);
  }
  return outcome;
}

Outcome reverses_with_its_control_points(const Evaluator& method) {
  Inputs inputs(9);
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {1, 2, 3, 6})) {
    const auto c = inputs.coefficients(degree, 1);
    const std::vector<double> reversed(c.rbegin(), c.rend());
    const double t = inputs.unit();
    const auto& kernel = method.kernel(1);
    expect_near(outcome, evaluate(kernel, view(Form::bernstein, 1, degree, reversed), {1 - t})[0],
                evaluate(kernel, view(Form::bernstein, 1, degree, c), {t})[0], tolerance(degree), degree, t);
  }
  return outcome;
}

Outcome scales_with_powers_of_two(const Evaluator& method) {
  const auto ts = parameters_for(method.info());
  Inputs inputs(4);
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {0, 1, 3, 8, 20})) {
    const auto coefficients = inputs.coefficients(degree, 2);
    auto scaled = coefficients;
    for (double& value : scaled) value *= 0x1p+60;
    const auto points = evaluate(method.kernel(2), view(method.info().form, 2, degree, coefficients), ts);
    const auto found = evaluate(method.kernel(2), view(method.info().form, 2, degree, scaled), ts);
    for (std::size_t k = 0; k < points.size(); ++k)
      expect_same(outcome, found[k], 0x1p+60 * points[k], degree, ts[k / 2]);
  }
  return outcome;
}

Outcome treats_axes_alike(const Evaluator& method) {
  const auto ts = parameters_for(method.info());
  const auto form = method.info().form;
  Inputs inputs(5);
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {1, 4, 20})) {
    const auto coefficients = inputs.coefficients(degree, 3);
    const auto points = evaluate(method.kernel(3), view(form, 3, degree, coefficients), ts);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> one_axis;
      for (std::size_t i = axis; i < coefficients.size(); i += 3) one_axis.push_back(coefficients[i]);
      const auto values = evaluate(method.kernel(1), view(form, 1, degree, one_axis), ts);
      for (std::size_t k = 0; k < ts.size(); ++k) expect_same(outcome, points[3 * k + axis], values[k], degree, ts[k]);
    }
  }
  return outcome;
}

Outcome gives_the_same_in_batches(const Evaluator& method) {
  const auto ts = parameters_for(method.info());
  Inputs inputs(6);
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {9})) {
    const auto coefficients = inputs.coefficients(degree, 2);
    const auto curve = view(method.info().form, 2, degree, coefficients);
    const auto points = evaluate(method.kernel(2), curve, ts);
    for (std::size_t k = 0; k < ts.size(); ++k) {
      const auto point = evaluate(method.kernel(2), curve, {ts[k]});
      for (std::size_t axis = 0; axis < 2; ++axis)
        expect_same(outcome, points[2 * k + axis], point[axis], degree, ts[k]);
    }
  }
  return outcome;
}

Outcome interpolates_end_points(const Evaluator& method) {
  Inputs inputs(7);
  Outcome outcome;
  for (const int degree : degrees_for(method.info(), {1, 2, 7, 20, 90})) {
    const auto coefficients = inputs.coefficients(degree, 2);
    const auto points = evaluate(method.kernel(2), view(Form::bernstein, 2, degree, coefficients), {0, 1});
    for (std::size_t axis = 0; axis < 2; ++axis) {
      expect_same(outcome, points[axis], coefficients[axis], degree, 0);
      expect_same(outcome, points[2 + axis], coefficients[coefficients.size() - 2 + axis], degree, 1);
    }
  }
  return outcome;
}

bool any(const MethodInfo& /*info*/) { return true; }
bool is_bounded(const MethodInfo& info) { return info.bound.has_value(); }
bool is_bernstein(const MethodInfo& info) { return info.form == Form::bernstein; }  // power form has no mirror image
bool is_stable(const MethodInfo& info) { return info.bit_stable; }                  // other bits belong to libm
bool is_native_and_bounded(const MethodInfo& info) {
  return is_bernstein(info) && is_bounded(info) && info.id.find(':') == std::string_view::npos;
}

constexpr std::array<Property, 13> all{{
    {"bound", "no error is beyond the bound that the method states", is_bounded, keeps_its_bound},
    {"bound_in_float", "nor is any in float", is_bounded, keeps_its_bound_in_float},
    {"bound_underflow", "nor where whole curves or their errors are subnormal", is_bounded,
     keeps_its_bound_where_it_underflows},
    {"bound_overflow", "nor, in double and float, where results come near overflow or beyond", is_bounded,
     keeps_its_bound_up_to_overflow},
    {"largest_degree", "at its largest degrees, in double and float, coordinates of at most 1 give numbers", any,
     works_up_to_its_largest_degree},
    {"mild_curves", "errors are small on curves of low degree in [-1, 1], t in [0, 1]", any, is_right_on_mild_curves},
    {"constants", "a curve whose control points are equal is that point, to rounding", any, reproduces_constants},
    {"affine_maps", "an affine map of the curve maps its points, to rounding", any, is_affinely_invariant},
    {"reversal", "control points in reverse give the same curve from its other end, to rounding", is_bernstein,
     reverses_with_its_control_points},
    {"powers_of_two", "a power of two as factor changes no other bit", is_stable, scales_with_powers_of_two},
    {"axes", "each axis is evaluated as if it were alone, bit for bit", any, treats_axes_alike},
    {"batches", "many t at once give the bits of one at a time", any, gives_the_same_in_batches},
    {"end_points", "t = 0 and t = 1 give the first and the last control point exactly", is_native_and_bounded,
     interpolates_end_points},
}};

}  // namespace

std::vector<Evaluator> evaluators() {
  std::vector<Evaluator> methods;
  for (std::size_t place = 0; place < kernels<double>(2).size(); ++place)
    methods.push_back({{&kernels<double>(1)[place], &kernels<double>(2)[place], &kernels<double>(3)[place]},
                       &kernels<float>(2)[place]});
  return methods;
}

std::span<const Property> properties() { return all; }

}  // namespace bezierbench::requirements
