// SPDX-License-Identifier: MIT
#include "experiments/metric/class_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/bound/amplification.hpp"

namespace bezierbench::metric {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The largest Euclidean norm of a coefficient.
double largest_norm(const CurveClass& of) { return of.range * std::sqrt(static_cast<double>(of.dimension)); }

/// The parameters at which an amplification, or its quotient by p~, can be largest over the interval: with all
/// coefficients equal each is monotone on every piece between and beyond 0, 1/2 and 1, or has a single minimum there
/// (core/bound/amplification.hpp has the formulas: powers of |t|, 1 + |t|, |t| + |1 - t|, 3|t| + |1 - t|, 1/2 + |t -
/// 1/2| and 1 + 2 min(|t|, |1 - t|)).
std::vector<double> extreme_parameters(const CurveClass& of) {
  std::vector<double> all{of.t_min, of.t_max};
  for (const double t : {0.0, 0.5, 1.0})
    if (of.t_min < t && t < of.t_max) all.push_back(t);
  return all;
}

/// The largest amplification over all members of the class; it grows with each coefficient. Points of the class are up
/// to twice its norm apart.
double largest_amplification(Amplification kind, const CurveClass& of) {
  const double farthest = anchor_of(kind) == Anchor::none ? largest_norm(of) : 2 * largest_norm(of);
  const std::vector<double> norms(static_cast<std::size_t>(of.degree) + 1, farthest);
  double largest = 0;
  for (const double t : extreme_parameters(of)) largest = std::max(largest, amplification(kind, norms, t));
  return largest;
}

/// The magnitudes of a curve whose only coefficient is 1, counted from the anchor of the amplification.
std::vector<double> single_coefficient(int single, Amplification kind, int degree, double t) {
  const bool at_start = anchor_of(kind) == Anchor::start || t + t <= 1;
  const bool is_anchor = anchor_of(kind) != Anchor::none && single == (at_start ? 0 : degree);
  std::vector<double> magnitudes(static_cast<std::size_t>(degree) + 1, is_anchor ? 1 : 0);
  magnitudes[static_cast<std::size_t>(single)] = is_anchor ? 0 : 1;
  return magnitudes;
}

/// At least the largest amplification / p~ over all members of the class. No curve has more than some curve with a
/// single coefficient, because an amplification is at most the sum of those of the single coefficients, and a quotient
/// of sums of positive terms is at most the largest quotient of two terms. Where magnitudes are counted from 0 those
/// quotients ascend or descend in the index of the coefficient, so the first or the last is the largest.
double largest_quotient(Amplification kind, const CurveClass& of) {
  double largest = 1;
  const int step = anchor_of(kind) == Anchor::none ? std::max(of.degree, 1) : 1;
  for (const double t : extreme_parameters(of))
    for (int single = 0; single <= of.degree; single += step) {
      const double amplified = amplification(kind, single_coefficient(single, kind, of.degree, t), t);
      const double p_tilde =
          amplification(p_tilde_of(of.form), single_coefficient(single, p_tilde_of(of.form), of.degree, t), t);
      if (amplified > 0) largest = std::max(largest, amplified / p_tilde);
    }
  return largest;
}

/// The largest (|t| + |1 - t|)^n.
double largest_reach(const CurveClass& of) {
  double largest = 1;
  for (const double t : extreme_parameters(of))
    largest = std::max(largest, integer_power(std::abs(t) + std::abs(1 - t), of.degree));
  return largest;
}

bool in_range(const reference::BoundAtDegree& at_degree, const CurveClass& of,
              const reference::Arithmetic& arithmetic) {
  const double size =
      at_degree.bound.underflow_scales_with_coefficients ? std::max(largest_norm(of), 1.0) : largest_norm(of);
  return stays_in_range(at_degree.growth * size * largest_reach(of), of.degree, arithmetic.unit_roundoff);
}

bool is_covered(const reference::BoundAtDegree& at_degree, const CurveClass& of,
                const reference::Arithmetic& arithmetic) {
  if (of.form != Form::bernstein && of.form != Form::power) return false;
  if (at_degree.bound.unit_interval_only && (of.t_min < 0 || of.t_max > 1)) return false;
  return std::isfinite(at_degree.factor) && in_range(at_degree, of, arithmetic);
}

/// What underflow adds, in coordinate units.
double underflow(const reference::BoundAtDegree& at_degree, const CurveClass& of,
                 const reference::Arithmetic& arithmetic) {
  const double size = at_degree.bound.underflow_scales_with_coefficients ? 1 + largest_norm(of) : 1;
  return of.dimension * (arithmetic.smallest_subnormal * size * at_degree.underflow * largest_reach(of));
}

}  // namespace

double min_p_tilde(const CurveClass& of, const reference::Arithmetic& arithmetic) {
  return of.range / std::sqrt(arithmetic.range);
}

ClassBound class_bound(const ErrorBound& bound, const CurveClass& of, const reference::Arithmetic& arithmetic) {
  const reference::BoundAtDegree at_degree(bound, of.degree, arithmetic);
  if (!is_covered(at_degree, of, arithmetic)) return {infinite, infinite};
  const ClassBound of_local = bound.of_local == nullptr ? ClassBound{} : class_bound(*bound.of_local, of, arithmetic);
  const double u = arithmetic.unit_roundoff;
  const double lost = underflow(at_degree, of, arithmetic);
  // |p| <= p~
  const double result =
      bound.result_roundings == 0 ? 0 : bound.result_roundings * largest_amplification(p_tilde_of(of.form), of);
  const double coordinate = (result + at_degree.factor * largest_amplification(bound.amplification, of)) * u + lost;
  const double in_u = bound.result_roundings + at_degree.factor * largest_quotient(bound.amplification, of) +
                      lost / u / min_p_tilde(of, arithmetic);
  return {coordinate + of_local.coordinate, in_u + of_local.in_u};  // on different axes
}

}  // namespace bezierbench::metric
