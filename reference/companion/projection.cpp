// SPDX-License-Identifier: MIT
#include "reference/companion/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/companion/integer_polynomial.hpp"

namespace bezierbench::reference {
namespace {

/// The polynomials of one problem, all over one power of two, 2^exponent per coordinate.
struct Problem {
  std::vector<IntegerPolynomial> offsets;  ///< C - P, axis by axis
  IntegerPolynomial slope;                 ///< (C - P).C'
  IntegerPolynomial squared;               ///< |C - P|^2
  long exponent = 0;
};

IntegerPolynomial product(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial result(a.empty() || b.empty() ? 0 : a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

void add(IntegerPolynomial& sum, const IntegerPolynomial& term) {
  if (sum.size() < term.size()) sum.resize(term.size(), 0);
  for (std::size_t i = 0; i < term.size(); ++i) sum[i] += term[i];
  while (!sum.empty() && sum.back() == 0) sum.pop_back();
}

/// x 2^-exponent, an integer.
mpz_class integer(double x, long exponent) {
  const auto exact = exactly(x);
  if (exact.numerator == 0) return 0;
  return exact.numerator << static_cast<mp_bitcnt_t>(exact.exponent - exponent);
}

Problem problem_of(const CurveView<double>& curve, std::span<const double> point) {
  Problem problem;
  for (const auto values : {curve.coefficients, point})
    for (const double x : values) problem.exponent = std::min(problem.exponent, exactly(x).exponent);
  for (int axis = 0; axis < curve.dimension; ++axis) {
    const mpz_class p = integer(point[static_cast<std::size_t>(axis)], problem.exponent);
    std::vector<mpz_class> scaled;
    mpz_class binomial = 1;
    for (int i = 0; i <= curve.degree; ++i) {
      scaled.emplace_back((integer(curve(axis, i), problem.exponent) - p) * binomial);
      binomial = binomial * (curve.degree - i) / (i + 1);
    }
    const auto offset = from_scaled_bernstein(scaled);
    add(problem.squared, product(offset, offset));
    add(problem.slope, product(offset, derivative(offset)));
    problem.offsets.push_back(offset);
  }
  return problem;
}

/// |C - P|^2 at a dyadic t.
Rational squared_at(const IntegerPolynomial& squared, long exponent, const Dyadic& t) {
  Rational value;
  for (std::size_t i = squared.size(); i-- > 0;)
    value.numerator = value.numerator * t.k + (squared[i] << (t.shift * (squared.size() - 1 - i)));
  const auto degree = squared.empty() ? 0 : static_cast<long>(squared.size()) - 1;
  value.exponent = 2 * exponent - degree * static_cast<long>(t.shift);
  return value;
}

Rational rational(const Dyadic& t) { return {t.k, 1, -static_cast<long>(t.shift)}; }

/// Where all axes of C - P vanish, square-free; constant where they never do.
IntegerPolynomial common_zeros(const Problem& problem) {
  IntegerPolynomial common;
  for (const auto& offset : problem.offsets) common = greatest_common_divisor(common, offset);
  return common.size() < 2 ? common : square_free(common);
}

constexpr unsigned long least_bits = 128;
constexpr unsigned long most_bits = 1200;  // beyond the smallest double

/// Narrow enough for the distance, and for t rounded to double.
void refine_root(const IntegerPolynomial& p, RootInterval& root) {
  for (unsigned long bits = least_bits; !root.exact && bits <= most_bits; bits *= 2) {
    refine(p, root, bits);
    const Dyadic other{root.t.k + 1, root.t.shift};
    if (root.exact || round_to(binary64, rational(root.t)) == round_to(binary64, rational(other))) return;
  }
}

CriticalPoint critical_point(const Problem& problem, const RootInterval& root, const IntegerPolynomial& zeros) {
  CriticalPoint point{rational(root.t), squared_at(problem.squared, problem.exponent, root.t)};
  if (root.exact || zeros.size() < 2) return point;
  const Dyadic other{root.t.k + 1, root.t.shift};
  if (sign_at(zeros, root.t) * sign_at(zeros, other) < 0) point.distance_squared = {};
  return point;
}

/// The square root of b >= 0, cut to 256 bits.
Rational root_of(const Rational& b) {
  if (b.numerator == 0) return b;
  constexpr long root_bits = 256;
  const long drop = floor_log2(b) / 2 - root_bits;  // of the root
  const long shift = b.exponent - 2 * drop;
  mpz_class integer = shift >= 0 ? mpz_class(b.numerator << static_cast<mp_bitcnt_t>(shift))
                                 : mpz_class(b.numerator >> static_cast<mp_bitcnt_t>(-shift));
  return {sqrt(integer), 1, drop};
}

}  // namespace

ExactProjection projection(const CurveView<double>& curve, std::span<const double> point) {
  const auto problem = problem_of(curve, point);
  ExactProjection result{{}, 0, problem.squared, problem.exponent};
  const auto add_end = [&](unsigned long k) {
    const Dyadic t{k, 0};
    result.critical.push_back({rational(t), squared_at(problem.squared, problem.exponent, t)});
  };
  add_end(0);
  if (!problem.slope.empty()) {  // else the curve is one point
    const auto slope = square_free(problem.slope);
    const auto zeros = common_zeros(problem);
    for (auto& root : isolate_roots(slope)) {
      if (root.exact && root.t.k == 0) continue;
      if (root.exact && root.t.shift == 0) continue;
      refine_root(slope, root);
      result.critical.push_back(critical_point(problem, root, zeros));
    }
  }
  add_end(1);
  for (std::size_t i = 1; i < result.critical.size(); ++i)
    if (less(result.critical[i].distance_squared, result.foot().distance_squared)) result.nearest = i;
  return result;
}

Rational ExactProjection::distance_squared_at(double t) const {
  const Rational place = exactly(t);
  const bool whole = place.exponent >= 0;
  return squared_at(squared, exponent,
                    {whole ? mpz_class(place.numerator << static_cast<mp_bitcnt_t>(place.exponent)) : place.numerator,
                     whole ? 0 : static_cast<unsigned long>(-place.exponent)});
}

double distance_error(const Format& format, double a, const Rational& b) {
  return round_to(format, abs(exactly(a) - root_of(b)));
}

double foot_error(const Format& format, double t, double distance, const ExactProjection& exact) {
  if (!std::isfinite(t) || !std::isfinite(distance)) return std::numeric_limits<double>::infinity();
  const auto& least = exact.foot().distance_squared;
  const double of_distance = distance_error(format, distance, least);
  const double of_place = round_to(format, abs(root_of(exact.distance_squared_at(t)) - root_of(least)));
  return of_place > 2 * of_distance ? of_place : of_distance;
}

}  // namespace bezierbench::reference
