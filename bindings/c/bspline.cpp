// SPDX-License-Identifier: MIT
// B-spline curves and NURBS.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/curve.hpp"
#include "core/bspline/kernel.hpp"
#include "reference/companion/bspline_control_points.hpp"

using namespace bezierbench;

struct bb_bspline_made {
  BsplineCurve curve;
};

namespace {

std::vector<double> copied(const double* values, std::size_t count) {
  const auto finite = c::finite_values(values, count);
  return {finite.begin(), finite.end()};
}

/// The curve of the caller. Throws Refused for arguments that do not make one.
BsplineCurve bspline_of(const bb_bspline* given) {
  c::require_pointers(given);
  c::require_shape(given->dimension, given->degree);
  c::require(given->degree >= 1, BB_ERROR_DEGREE);
  const auto n = static_cast<std::size_t>(given->degree);
  const auto d = static_cast<std::size_t>(given->dimension);
  c::require(given->count > n, BB_ERROR_COUNT);
  c::require(given->count <= std::numeric_limits<std::size_t>::max() / d / sizeof(double) - 2 * n, BB_ERROR_MEMORY);
  BsplineCurve curve{given->dimension,
                     given->degree,
                     copied(given->knots, given->count + n + 1),
                     copied(given->points, given->count * d),
                     {}};
  if (given->weights != nullptr) curve.weights = copied(given->weights, given->count);
  c::require(std::ranges::is_sorted(curve.knots) && curve.begin() < curve.end(), BB_ERROR_PARAMETER);
  c::require(std::ranges::all_of(curve.weights, [](double w) { return w > 0; }), BB_ERROR_NO_POINT);
  return curve;
}

/// `count` numbers in the domain of the curve. Throws Refused.
std::span<const double> in_domain(const BsplineCurve& curve, const double* t, std::size_t count) {
  const auto values = c::finite_values(t, count);
  c::require(std::ranges::all_of(values, [&](double x) { return x >= curve.begin() && x <= curve.end(); }),
             BB_ERROR_PARAMETER);
  return values;
}

BsplineCurve checked(std::optional<BsplineCurve> found) {
  c::require(found.has_value(), BB_ERROR_NO_POINT);
  const auto is_finite = [](double x) { return std::isfinite(x); };
  c::require(std::ranges::all_of(found->control_points, is_finite) && std::ranges::all_of(found->weights, is_finite),
             BB_ERROR_OVERFLOW);
  return std::move(*found);
}

/// The curve that `make` makes of that of the caller, before which the place for it is checked.
template <class Make>
int made_curve(const bb_bspline* given, bb_bspline_made** made, const Make& make) {
  return c::guarded([&] {
    const auto curve = bspline_of(given);
    c::require_pointers(made);
    *made = new bb_bspline_made{checked(make(curve))};
  });
}

/// How often a knot may stand.
std::ptrdiff_t most_times(const BsplineCurve& curve, double u) {
  return curve.degree + (u == curve.begin() || u == curve.end() ? 1 : 0);
}

/// With every knot so often that the control points are those of the Bernstein form of the spans.
BsplineCurve in_spans(const BsplineCurve& curve) {
  std::vector<double> missing;
  for (auto k = static_cast<std::size_t>(curve.degree); k <= curve.points(); ++k) {
    const double u = curve.knots[k];
    if (k < curve.points() && curve.knots[k + 1] == u) continue;  // the last time that it stands
    missing.resize(missing.size() + static_cast<std::size_t>(std::max<std::ptrdiff_t>(
                                        most_times(curve, u) - std::ranges::count(curve.knots, u), 0)),
                   u);
  }
  return checked(reference::with_knots_inserted(curve, missing));
}

}  // namespace

int bb_bspline_evaluate(const char* method, const bb_bspline* given, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    const auto curve = bspline_of(given);
    const auto parameters = in_domain(curve, t, count);
    const CurveView<double> of_degree{
        curve.weights.empty() ? Form::bernstein : Form::rational, curve.dimension, curve.degree, {}, {}};
    const auto& kernel = c::chosen(bspline_kernels(curve.dimension), method != nullptr ? method : "de_boor", of_degree);
    if (count > 0) c::require_pointers(out);
    const auto d = static_cast<std::size_t>(curve.dimension);
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) {
      const auto span = curve.span(curve.span_at(parameters[k]));
      values.resize(static_cast<std::size_t>(numbers_solved(kernel, span)));
      kernel.solve(span, parameters[k], values.data());
      std::copy_n(values.begin(), d, out + k * d);
    }
  });
}

int bb_bspline_exact(const bb_bspline* given, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    const auto curve = bspline_of(given);
    const auto parameters = in_domain(curve, t, count);
    if (count > 0) c::require_pointers(out);
    for (const double x : parameters) {
      const auto span = curve.span(curve.span_at(x));
      const auto basis = reference::ExactBsplineWeights::at(span.knots, x);
      const auto point =
          (span.weights.empty() ? basis : basis.with(span.weights)).sum(span.dimension, span.control_points);
      for (int axis = 0; axis < span.dimension; ++axis)
        *out++ = reference::round_to(reference::binary64, point.coordinate(axis));
    }
  });
}

int bb_bspline_spans(const bb_bspline* given, bb_curves** spans) {
  return c::guarded([&] {
    const auto curve = in_spans(bspline_of(given));
    c::require_pointers(spans);
    curves::CurveSet set;
    for (auto k = static_cast<std::size_t>(curve.degree); k < curve.points(); ++k) {
      if (curve.knots[k] == curve.knots[k + 1]) continue;
      const auto span = curve.span(k);
      const CurveView<double> view{span.weights.empty() ? Form::bernstein : Form::rational, span.dimension, span.degree,
                                   span.control_points, span.weights};
      const auto id = std::to_string(set.size());
      set.add(id, view, !set.continues_path(id, view));
    }
    *spans = new bb_curves{std::move(set)};
  });
}

int bb_bspline_insert(const bb_bspline* given, const double* knots, std::size_t count, bb_bspline_made** made) {
  return made_curve(given, made, [&](const BsplineCurve& curve) {
    const auto more = in_domain(curve, knots, count);
    for (const double u : more)
      c::require(std::ranges::count(curve.knots, u) + std::ranges::count(more, u) <= most_times(curve, u),
                 BB_ERROR_COUNT);
    return reference::with_knots_inserted(curve, more);
  });
}

int bb_bspline_remove(const bb_bspline* given, const double* knots, std::size_t count, bb_bspline_made** made,
                      double* deviation) {
  double largest = 0;
  const int status = made_curve(given, made, [&](const BsplineCurve& curve) -> std::optional<BsplineCurve> {
    c::require_pointers(deviation);
    const auto fewer = in_domain(curve, knots, count);
    for (const double u : fewer) {
      c::require(u > curve.begin() && u < curve.end(), BB_ERROR_COUNT);
      c::require(std::ranges::count(fewer, u) <= std::ranges::count(curve.knots, u), BB_ERROR_COUNT);
    }
    auto removal = reference::with_knots_removed(curve, fewer);
    if (!removal) return std::nullopt;
    largest = removal->deviation;
    return std::move(removal->curve);
  });
  if (status == BB_OK) *deviation = largest;
  return status;
}

int bb_bspline_elevate(const bb_bspline* given, int degree, bb_bspline_made** made) {
  return made_curve(given, made, [&](const BsplineCurve& curve) {
    c::require(degree >= curve.degree && degree <= reference::max_elevated_bspline_degree, BB_ERROR_DEGREE);
    return reference::elevated_bspline(curve, degree);
  });
}

int bb_bspline_part(const bb_bspline* given, double from, double to, bb_bspline_made** made) {
  return made_curve(given, made, [&](const BsplineCurve& curve) {
    const std::array ends{from, to};
    in_domain(curve, ends.data(), ends.size());
    c::require(from < to, BB_ERROR_PARAMETER);
    return reference::part_of_bspline(curve, from, to);
  });
}

int bb_bspline_derivative(const bb_bspline* given, int order, bb_bspline_made** made) {
  return made_curve(given, made, [&](const BsplineCurve& curve) {
    c::require(curve.weights.empty(), BB_ERROR_FORM);
    c::require(order >= 0 && order < curve.degree, BB_ERROR_PARAMETER);
    return std::optional(reference::derivative_of_bspline(curve, order));
  });
}

int bb_bspline_get(const bb_bspline_made* made, bb_bspline* curve) {
  return c::guarded([&] {
    c::require_pointers(made, curve);
    const auto& own = made->curve;
    *curve = {own.dimension,
              own.degree,
              own.points(),
              own.control_points.data(),
              own.weights.empty() ? nullptr : own.weights.data(),
              own.knots.data()};
  });
}

void bb_bspline_free(bb_bspline_made* made) { delete made; }
