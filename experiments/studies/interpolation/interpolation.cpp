// SPDX-License-Identifier: MIT
// Studies of kind `interpolation`: random points joined by the cubic Bezier segments of a C2 natural spline, whose
// control points are judged against the exact ones and by the conditions that they must meet. Writes interpolation.csv,
// with a row for each number of points and method.
#include "core/interpolate/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/judge/methods.hpp"
#include "experiments/studies/interpolation/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/error/norm.hpp"

namespace bezierbench::studies {

namespace {

using reference::Rational;

std::vector<double> axis_of(std::span<const double> values, std::size_t dimension, std::size_t axis) {
  std::vector<double> result;
  result.reserve(values.size() / dimension);
  for (std::size_t k = axis; k < values.size(); k += dimension) result.push_back(values[k]);
  return result;
}

/// value / unit, rounded once; 0 / 0 is 0.
double in_units(const Rational& value, const Rational& unit) {
  if (value.numerator == 0) return 0;
  if (unit.numerator == 0) return std::numeric_limits<double>::infinity();
  return reference::quotient(reference::error_format, value, unit);
}

/// Adds a value that is rounded already. Rounding by metric::to_24_bits would change subnormal values.
void add(double value, metric::Tally& tally) { tally.add(std::span(&value, 1)); }

const Rational underflow{residual_underflow, 1, -1074};

/// Whether no residual exceeds the bound.
bool within(const reference::SplineResiduals& residuals, double bound, const Rational& unit) {
  const Rational limit = reference::exactly(bound) * unit + underflow;
  const auto kept = [&](const Rational& residual) { return (residual - limit).numerator <= 0; };
  return kept(residuals.data) && kept(residuals.c0) && kept(residuals.c1) && kept(residuals.c2) &&
         kept(residuals.natural);
}

}  // namespace

SplineJudge::SplineJudge(std::span<const double> points, int dimension, bool with_exact) {
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t axis = 0; axis < d; ++axis) {
    Axis next{axis_of(points, d, axis), {}, std::nullopt};
    double largest = 0;
    for (const double x : next.coordinates) largest = std::max(largest, std::abs(x));
    next.unit = reference::exactly(largest) * Rational{1, 1, -53};
    if (with_exact) next.exact = reference::exact_spline(next.coordinates);
    axes_.push_back(std::move(next));
  }
}

void SplineJudge::judge(std::span<const double> segments, double bound, std::uint64_t trial,
                        SplineErrors& errors) const {
  if (!reference::all_finite(segments)) {
    ++errors.non_finite;
    return;
  }
  struct Largest {
    double error = 0, error_u = 0, data = 0, c0 = 0, c1 = 0, c2 = 0, natural = 0;
  } of;
  bool violates = false;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const Axis& axis = axes_[k];
    const auto values = axis_of(segments, axes_.size(), k);
    const auto residuals = reference::spline_residuals(axis.coordinates, values);
    violates = violates || (bound > 0 && !within(residuals, bound, axis.unit));
    if (bound > 0) errors.bound_u.add(bound + (axis.unit.numerator == 0 ? 0 : in_units(underflow, axis.unit)));
    const auto keep = [&](const Rational& residual, double& largest) {
      largest = std::max(largest, in_units(residual, axis.unit));
    };
    keep(residuals.data, of.data);
    keep(residuals.c0, of.c0);
    keep(residuals.c1, of.c1);
    keep(residuals.c2, of.c2);
    keep(residuals.natural, of.natural);
    if (!axis.exact) continue;
    const Rational error = reference::inner_point_error(*axis.exact, values);
    of.error = std::max(of.error, reference::round_to(reference::error_format, error));
    of.error_u = std::max(of.error_u, in_units(error, axis.unit));
  }
  add(of.data, errors.data);
  add(of.c0, errors.c0);
  add(of.c1, errors.c1);
  add(of.c2, errors.c2);
  add(of.natural, errors.natural);
  if (axes_.front().exact) {
    add(of.error, errors.error);
    add(of.error_u, errors.error_u);
  }
  if (violates) errors.violations.add(trial);
}

bool SplineJudge::meets(std::span<const double> segments, double bound) const {
  bool right = reference::all_finite(segments);
  for (std::size_t k = 0; right && k < axes_.size(); ++k) {
    const auto residuals = reference::spline_residuals(axes_[k].coordinates, axis_of(segments, axes_.size(), k));
    right = within(residuals, bound, axes_[k].unit);
  }
  return right;
}

namespace {

constexpr std::array interpolation_fields{suite::field<&suite::Study::points>(suite::points_key)};

}  // namespace

extern constexpr StudyKind interpolation_kind =
    companion_kind<InterpolationProblem>({.id = "interpolation",
                                          .about = "errors of splines through random points",
                                          .own = interpolation_fields,
                                          .methods_example = "[\"c2_natural\"]",
                                          .inputs = {.forms = suite::bernstein_form,
                                                     .forms_reason = "splines are of polynomial Bezier curves",
                                                     .double_only = true,
                                                     .degree = suite::DegreeUse::not_a_key,
                                                     .degree_reason = "degree is that of the segments, 3",
                                                     .parameters = suite::Parameters::whole,
                                                     .parameters_reason = "points are joined whole",
                                                     .sets = suite::SetUse::none,
                                                     .sets_reason = "splines go through drawn points",
                                                     .independent_points = true}},
                                         race::Size::points);

}  // namespace bezierbench::studies
