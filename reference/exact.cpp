// SPDX-License-Identifier: MIT
#include "reference/exact.hpp"

#include <cmath>
#include <limits>

#include "reference/exact_curve.hpp"

namespace bezierbench::reference {
namespace {

void require_finite_curve(const CurveView<double>& curve, double t) {
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::isfinite(t) || !std::ranges::all_of(curve.coefficients, finite) ||
      !std::ranges::all_of(curve.weights, finite))
    throw std::invalid_argument("bezierbench: the true point needs finite points, weights and t");
}

/// Calls use(axis, point) with the exact point of each coordinate as a curve of its own, so that any dimension will do.
template <class Use>
void each_axis(const CurveView<double>& curve, double t, const Use& use) {
  require_finite_curve(curve, t);
  ExactCurve exact;
  std::vector<double> coefficients(static_cast<std::size_t>(curve.degree) + 1);
  for (int axis = 0; axis < curve.dimension; ++axis) {
    for (int i = 0; i <= curve.degree; ++i) coefficients[static_cast<std::size_t>(i)] = curve(axis, i);
    use(static_cast<std::size_t>(axis), exact.point({curve.form, 1, curve.degree, coefficients, curve.weights}, t));
  }
}

}  // namespace

void exact_coordinates(const CurveView<double>& curve, double t, bool single, std::span<double> result) {
  each_axis(curve, t, [&](std::size_t axis, const ExactPoint& point) {
    result[axis] = point.exists() ? round_to(single ? binary32 : binary64, point.coordinate(0))
                                  : std::numeric_limits<double>::quiet_NaN();
  });
}

void exact_distances(const CurveView<double>& curve, double t, std::span<const double> values,
                     std::span<double> result) {
  each_axis(curve, t, [&](std::size_t axis, const ExactPoint& point) {
    if (!point.exists())
      result[axis] = std::numeric_limits<double>::quiet_NaN();
    else if (!std::isfinite(values[axis]))
      result[axis] = std::numeric_limits<double>::infinity();
    else
      result[axis] = round_to(binary64, abs(exactly(values[axis]) - point.coordinate(0)));
  });
}

}  // namespace bezierbench::reference
