// SPDX-License-Identifier: MIT
// True points, errors of values against them, and proved bounds of these errors.

#include <gmpxx.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "bindings/c/curve.hpp"
#include "bindings/c/more_axes.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

using namespace bezierbench;

namespace {

/// The true point at t. Throws Refused where there is none.
const reference::ExactPoint& true_point(reference::ExactCurve& exact, const CurveView<double>& curve, double t) {
  const auto& point = exact.point(curve, t);
  c::require(point.exists(), BB_ERROR_NO_POINT);
  return point;
}

/// True points, rounded once to `format`, which is that of Scalar. All are computed before the first is written.
template <class Scalar>
void write_points(const CurveView<double>& curve, std::span<const Scalar> ts, const reference::Format& format,
                  Scalar* out) {
  if (ts.empty()) return;
  c::require_pointers(out);
  reference::ExactCurve exact;
  std::vector<Scalar> points;
  for (const Scalar t : ts) {
    const auto& point = true_point(exact, curve, t);
    for (int axis = 0; axis < curve.dimension; ++axis)
      points.push_back(static_cast<Scalar>(reference::round_to(format, point.coordinate(axis))));
  }
  std::ranges::copy(points, out);
}

/// "numerator" or "numerator/denominator", in lowest terms.
std::string text_of(const reference::Rational& value) {
  mpq_class fraction(value.numerator, value.denominator);
  fraction.canonicalize();
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(value.exponent));
  if (value.exponent < 0)
    fraction >>= shift;
  else
    fraction <<= shift;
  return fraction.get_str();
}

}  // namespace

int bb_exact(int dimension, int degree, const double* points, const double* t, std::size_t count, double* out) {
  const bb_curve curve{BB_BERNSTEIN, dimension, degree, points, nullptr};
  return bb_curve_exact(&curve, t, count, out);
}

int bb_exact_float(int dimension, int degree, const float* points, const float* t, std::size_t count, float* out) {
  return c::guarded([&] {
    const auto curve = c::bezier_curve(dimension, degree, points);
    const std::vector<double> wide(curve.coefficients.begin(), curve.coefficients.end());
    write_points({Form::bernstein, dimension, degree, wide, {}}, c::finite_values(t, count), reference::binary32, out);
  });
}

int bb_curve_exact(const bb_curve* curve, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    if (c::has_more_axes(curve))
      return c::by_axes(*curve, count, out, [&](const bb_curve& part, double* of_part) {
        return bb_curve_exact(&part, t, count, of_part);
      });
    write_points(c::curve_of(curve), c::finite_values(t, count), reference::binary64, out);
  });
}

int bb_curve_exact_text(const bb_curve* curve, double t, int axis, char* text, std::size_t size,
                        std::size_t* required) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    c::finite_values(&t, 1);
    c::require(axis >= 0 && axis < view.dimension, BB_ERROR_COUNT);
    reference::ExactCurve exact;
    const auto result = text_of(true_point(exact, view, t).coordinate(axis));
    if (required != nullptr) *required = result.size() + 1;
    c::require(result.size() < size, BB_ERROR_COUNT);
    c::require_pointers(text);
    std::copy_n(result.c_str(), result.size() + 1, text);
  });
}

int bb_curve_error(const bb_curve* curve, const double* t, std::size_t count, const double* values, bb_error* errors) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto ts = c::finite_values(t, count);
    if (ts.empty()) return;
    c::require_pointers(values, errors);
    reference::ExactCurve exact;
    std::vector<bb_error> result;
    for (const double at : ts) {
      const auto truth = true_point(exact, view, at);  // a copy: the next call changes the original
      const auto& p_tilde = exact.p_tilde(view, at);
      for (int axis = 0; axis < view.dimension; ++axis) {
        const auto judged =
            reference::coordinate_error(values[result.size()], truth.coordinate(axis), p_tilde.coordinate(axis));
        result.push_back({judged.exact, judged.error, judged.error_ulp, judged.error_u});
      }
    }
    std::ranges::copy(result, errors);
  });
}

// Proved bounds of methods.

using namespace bezierbench;

namespace {

/// The bounds at every t of a curve in double, whose values may be those of floats. Throws Refused where there are none.
template <class Scalar>
void write_bounds(const MethodInfo& info, const CurveView<double>& curve, std::span<const Scalar> ts,
                  const reference::Arithmetic& arithmetic, bb_bound* bounds) {
  c::require(info.bound.has_value(), BB_ERROR_NO_BOUND);
  if (ts.empty()) return;
  c::require_pointers(bounds);
  reference::ExactCurve exact;
  std::vector<bb_bound> result;
  for (const double at : ts) {
    const auto truth = exact.point(curve, at);  // a copy: the next call changes the original
    c::require(truth.exists(), BB_ERROR_NO_POINT);
    const auto& p_tilde = exact.p_tilde(curve, at);
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const double bound =
          reference::coordinate_bound(*info.bound, curve, axis, at, truth.coordinate(axis), arithmetic);
      const auto units = reference::bound_units(bound, p_tilde.coordinate(axis), arithmetic);
      result.push_back({bound, units.value_or(std::numeric_limits<double>::infinity())});
    }
  }
  std::ranges::copy(result, bounds);
}

}  // namespace

int bb_curve_bound(const char* method, const bb_curve* curve, const double* t, std::size_t count, bb_bound* bounds) {
  return c::guarded([&] {
    const auto view = c::curve_of(curve);
    const auto& info = *c::evaluator(method, view).info;
    write_bounds(info, view, c::parameters(info, t, count), reference::double_arithmetic, bounds);
  });
}

int bb_bound_float(const char* method, int dimension, int degree, const float* points, const float* t,
                   std::size_t count, bb_bound* bounds) {
  return c::guarded([&] {
    const auto view = c::bezier_curve(dimension, degree, points);
    const auto& info = *c::evaluator(method, view).info;
    const std::vector<double> values(view.coefficients.begin(), view.coefficients.end());
    write_bounds(info, {Form::bernstein, dimension, degree, values}, c::parameters(info, t, count),
                 reference::float_arithmetic, bounds);
  });
}
