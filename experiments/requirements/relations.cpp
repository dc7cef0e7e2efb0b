// SPDX-License-Identifier: MIT
#include "experiments/requirements/relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/requirements/parameters.hpp"
#include "experiments/requirements/seeded_curves.hpp"

namespace bezierbench::requirements {
namespace {

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

}  // namespace

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

}  // namespace bezierbench::requirements
