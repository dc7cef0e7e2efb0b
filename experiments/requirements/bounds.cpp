// SPDX-License-Identifier: MIT
#include "experiments/requirements/bounds.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/metric/trial_scale.hpp"
#include "experiments/requirements/parameters.hpp"
#include "experiments/requirements/seeded_curves.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::requirements {
namespace {

/// Holds points of one method to its bound.
class BoundedPoints {
 public:
  BoundedPoints(const MethodInfo& info, const metric::Arithmetic& arithmetic) : info_(info), arithmetic_(arithmetic) {}

  void judge(const CurveView<double>& curve, double t, std::span<const double> point) {
    scale_.set(curve, t);
    const double error = reference::Distance(exact_.point(curve, t)).to(point);
    const double bound = scale_.bound(*info_.bound, arithmetic_);
    bounded_ += std::isfinite(bound) ? 1 : 0;
    outcome_.expect(!metric::TrialScale::violates(error, bound), [&] {
      return fmt::format("degree {}, {} axes, t {}: error {}, bound {}", curve.degree, curve.dimension, t, error,
                         bound);
    });
  }

  /// With an infinite bound nothing is tested, so at least half of the cases must have a finite one.
  [[nodiscard]] Outcome outcome() {
    outcome_.expect(2 * bounded_ >= outcome_.cases(),
                    [&] { return fmt::format("only {} of these cases have a finite bound", bounded_); });
    return outcome_;
  }

 private:
  const MethodInfo& info_;
  const metric::Arithmetic& arithmetic_;
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

void judge_points(const Kernel<double>& kernel, int degree, const std::vector<double>& coefficients,
                  const std::vector<double>& ts, BoundedPoints& judge) {
  const auto curve = view(kernel.info->form, kernel.dimension, degree, coefficients);
  const auto points = evaluate(kernel, curve, ts);
  const auto d = static_cast<std::size_t>(kernel.dimension);
  for (std::size_t k = 0; k < ts.size(); ++k) judge.judge(curve, ts[k], std::span(points).subspan(k * d, d));
}

}  // namespace

Outcome keeps_its_bound(const Evaluator& method) {
  Inputs inputs(1);
  BoundedPoints judge(method.info(), metric::double_arithmetic);
  for (const int dimension : {1, 2, 3})
    for (const int degree : degrees_for(method.info(), {0, 1, 2, 3, 5, 8, 13, 20, 34, 60, 120})) {
      for (int repeat = 0; repeat < 20; ++repeat) {
        auto coefficients = inputs.coefficients(degree, dimension);
        if (repeat % 4 == 3)  // magnitudes from 2^-40 to 2^40 side by side
          for (double& value : coefficients) value = std::ldexp(value, static_cast<int>(80 * inputs.symmetric() / 2));
        judge_points(method.kernel(dimension), degree, coefficients, with_random(parameters(), inputs, 8), judge);
      }
    }
  return judge.outcome();
}

Outcome keeps_its_bound_in_float(const Evaluator& method) {
  Inputs inputs(2);
  BoundedPoints judge(method.info(), metric::float_arithmetic);
  for (const int degree : degrees_for<float>(*method.in_float->info, {0, 1, 2, 3, 8, 20, 34})) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto drawn = inputs.coefficients(degree, 2);
      const std::vector<float> coefficients(drawn.begin(), drawn.end());
      const std::vector<double> widened(coefficients.begin(), coefficients.end());
      const auto t = static_cast<float>(inputs.unit());
      const auto point = evaluate<float>(*method.in_float, view(method.info().form, 2, degree, coefficients), {t});
      judge.judge(view(method.info().form, 2, degree, widened), t, std::vector<double>(point.begin(), point.end()));
    }
  }
  return judge.outcome();
}

Outcome keeps_its_bound_where_it_underflows(const Evaluator& method) {
  Inputs inputs(10);
  BoundedPoints judge(method.info(), metric::double_arithmetic);
  for (const int exponent : {-900, -960, -1020, -1060, -1070})
    for (const int degree : degrees_for(method.info(), {0, 1, 2, 5, 20, 34})) {
      for (int repeat = 0; repeat < 10; ++repeat) {
        auto coefficients = inputs.coefficients(degree, 1);
        for (double& value : coefficients) value = std::ldexp(value, exponent);
        judge_points(method.kernel(1), degree, coefficients, with_random(parameters(), inputs, 4), judge);
      }
    }
  return judge.outcome();
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
