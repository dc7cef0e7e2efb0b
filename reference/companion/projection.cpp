// SPDX-License-Identifier: MIT
#include "reference/companion/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reference/companion/integer_polynomial.hpp"

namespace bezierbench::reference {
namespace {

/// The polynomials of one problem, all over one power of two, 2^exponent per coordinate.
struct Problem {
  std::vector<IntegerPolynomial> offsets;  ///< C - P, axis by axis
  IntegerPolynomial slope;                 ///< (C - P).C'
  IntegerPolynomial squared;               ///< |C - P|^2
  long exponent = 0;
  IntegerPolynomial weight = {};  ///< of a rational curve; the others are then of V = W (C - P) and V'W - VW'
};

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
  long weight_exponent = 0;
  for (const double w : curve.weights) weight_exponent = std::min(weight_exponent, exactly(w).exponent);
  const auto polynomial = [&](auto coefficient) {
    std::vector<mpz_class> scaled;
    mpz_class binomial = 1;
    for (int i = 0; i <= curve.degree; ++i) {
      scaled.emplace_back(coefficient(i) * binomial);
      if (!curve.weights.empty()) scaled.back() *= integer(curve.weights[static_cast<std::size_t>(i)], weight_exponent);
      binomial = binomial * (curve.degree - i) / (i + 1);
    }
    return from_scaled_bernstein(scaled);
  };
  if (!curve.weights.empty()) problem.weight = polynomial([](int) { return mpz_class(1); });
  for (int axis = 0; axis < curve.dimension; ++axis) {
    const mpz_class p = integer(point[static_cast<std::size_t>(axis)], problem.exponent);
    const auto offset = polynomial([&](int i) { return mpz_class(integer(curve(axis, i), problem.exponent) - p); });
    add(problem.squared, product(offset, offset));
    auto velocity = derivative(offset);
    if (!problem.weight.empty()) {
      velocity = product(velocity, problem.weight);
      auto other = product(offset, derivative(problem.weight));
      for (auto& x : other) x = -x;
      add(velocity, other);
    }
    add(problem.slope, product(offset, velocity));
    problem.offsets.push_back(offset);
  }
  return problem;
}

/// |C - P|^2 at a dyadic t.
Rational squared_at(const IntegerPolynomial& squared, const IntegerPolynomial& weight, long exponent, const Dyadic& t) {
  const auto degree_of = [](const IntegerPolynomial& p) { return p.empty() ? 0 : static_cast<long>(p.size()) - 1; };
  const auto shift = static_cast<long>(t.shift);
  const mpz_class w = weight.empty() ? mpz_class(1) : value_at(weight, t);
  return {value_at(squared, t), w * w, 2 * exponent + (2 * degree_of(weight) - degree_of(squared)) * shift};
}

Rational rational(const Dyadic& t) { return {t.k, 1, -static_cast<long>(t.shift)}; }

/// Where all axes of C - P vanish, square-free; constant where they never do.
IntegerPolynomial common_zeros(const Problem& problem) {
  IntegerPolynomial common;
  for (const auto& offset : problem.offsets) common = greatest_common_divisor(common, offset);
  return common.size() < 2 ? common : square_free(common);
}

constexpr unsigned long min_bits = 128;
constexpr unsigned long max_bits = 1200;  // beyond the smallest double
constexpr long distance_bits = 256;       // of a squared distance from a rational curve

/// Narrow enough for t rounded to double, and for the distance from a polynomial curve.
void refine_root(const IntegerPolynomial& p, RootInterval& root) {
  for (unsigned long bits = min_bits; !root.exact && bits <= max_bits; bits *= 2) {
    refine(p, root, bits);
    const Dyadic other{root.t.k + 1, root.t.shift};
    if (root.exact || round_to(binary64, rational(root.t)) == round_to(binary64, rational(other))) return;
  }
}

/// Whether the root is one of `zeros`, of which each is a root of the same polynomial.
bool is_among(const IntegerPolynomial& zeros, const RootInterval& root) {
  if (zeros.size() < 2) return false;
  const int sign = sign_at(zeros, root.t);
  return root.exact ? sign == 0 : sign * sign_at(zeros, {root.t.k + 1, root.t.shift}) < 0;
}

CriticalPoint critical_point(const Problem& problem, const RootInterval& root, const IntegerPolynomial& zeros) {
  CriticalPoint point{rational(root.t), squared_at(problem.squared, problem.weight, problem.exponent, root.t)};
  if (is_among(zeros, root)) point.distance_squared = {};
  return point;
}

/// Compares the distances at critical points, exactly. Where intervals do not tell them apart, however narrow they get,
/// both are one root of the polynomial whose roots are all critical values.
class Nearest {
 public:
  Nearest(const Problem& problem, const IntegerPolynomial& slope) : squared_(problem.squared), slope_(slope) {
    for (std::size_t i = 2; i < squared_.size(); ++i)
      bend_ += abs(squared_[i]) * static_cast<unsigned long>(i * (i - 1));
  }

  /// Whether the curve is nearer at `a` than at `b`. Narrows both where that is required.
  bool is_nearer(RootInterval& a, RootInterval& b) {
    for (;;) {
      const Range range_a = range(a);
      const Range range_b = range(b);
      const auto shift = std::max(range_a.value.shift, range_b.value.shift);
      const auto at_shift = [shift](const Range& range, const mpz_class& k) {
        return mpz_class(k << (shift - range.value.shift));
      };
      const mpz_class low_a = at_shift(range_a, range_a.value.k - range_a.off);
      const mpz_class low_b = at_shift(range_b, range_b.value.k - range_b.off);
      const mpz_class high_a = at_shift(range_a, range_a.value.k + range_a.off);
      const mpz_class high_b = at_shift(range_b, range_b.value.k + range_b.off);
      if (high_a < low_b) return true;
      if (high_b < low_a || (a.exact && b.exact)) return false;
      if (!is_narrow(a) || !is_narrow(b)) {
        for (auto* root : {&a, &b}) refine(slope_, *root, narrow_bits());
        continue;
      }
      const mpz_class low = std::min(low_a, low_b) - 1;
      const mpz_class high = std::max(high_a, high_b) + 1;
      if (is_critical(a, range_a.value) && is_critical(b, range_b.value) &&
          has_one_root(critical_values(), {low, shift}, high - low))
        return false;
      for (auto* root : {&a, &b}) refine(slope_, *root, 2 * root->t.shift);
    }
  }

 private:
  /// |C - P|^2, as `squared` has it, at the beginning of an interval of t; at the root it is at most `off` / 2^shift
  /// off.
  struct Range {
    Dyadic value;
    mpz_class off;
  };
  /// D' is 0 at the root, so that the values there and elsewhere in an interval of width w differ by at most w^2/2 max
  /// |D''|.
  [[nodiscard]] Range range(const RootInterval& root) const {
    const auto degree = squared_.size() - 1;  // at least 2: the curve is not one point
    return {{value_at(squared_, root.t), degree * root.t.shift},
            root.exact ? mpz_class(0) : mpz_class(bend_ << ((degree - 2) * root.t.shift))};
  }
  /// The critical values take long to compute, so they are left alone before intervals are narrow: values then are off
  /// by 2^-256 units of `squared` at most.
  [[nodiscard]] unsigned long narrow_bits() const { return 128 + mpz_sizeinbase(bend_.get_mpz_t(), 2) / 2; }
  [[nodiscard]] bool is_narrow(const RootInterval& root) const { return root.exact || root.t.shift >= narrow_bits(); }
  /// Whether the value at the root is a root of critical_values(). The value at an end need not be one.
  bool is_critical(const RootInterval& root, const Dyadic& value) {
    return !root.exact || sign_at(critical_values(), value) == 0;
  }
  const IntegerPolynomial& critical_values() {
    if (critical_values_.empty()) critical_values_ = minimal_polynomial(squared_, slope_);
    return critical_values_;
  }

  const IntegerPolynomial& squared_;  ///< D = |C - P|^2
  const IntegerPolynomial& slope_;    ///< square-free, with the roots of D'
  IntegerPolynomial critical_values_;
  mpz_class bend_ = 0;  ///< a bound of |D''| on [0, 1]
};

/// Compares the distances at critical points of a rational curve by enclosures of |V|^2 / W^2.
class NearestOfRational {
 public:
  NearestOfRational(const Problem& problem, const IntegerPolynomial& slope, const IntegerPolynomial& zeros)
      : problem_(problem), slope_(slope), zeros_(zeros) {}

  /// Narrows the interval until the squared distance is known to `bits` bits. W is not 0 at the root, so this ends.
  void narrow(RootInterval& root, long bits) const {
    while (!is_narrow(root, bits)) refine(slope_, root, std::max(2 * root.t.shift, min_bits));
  }

  /// Whether the curve is nearer at `a` than at `b`. Narrows both where that is required.
  bool is_nearer(RootInterval& a, RootInterval& b) const {
    for (long bits = first_bits;; bits *= 2) {
      for (auto* root : {&a, &b}) narrow(*root, bits);
      const bool a_is_zero = is_among(zeros_, a);
      if (is_among(zeros_, b)) return false;
      if (a_is_zero) return true;
      const auto range_a = range(a);
      const auto range_b = range(b);
      if (less(range_a->high, range_b->low)) return true;
      if (!less(range_a->low, range_b->high) || bits >= equal_bits) return false;
    }
  }

 private:
  static constexpr long first_bits = 128;
  static constexpr long equal_bits = 1024;

  struct Range {
    Rational low;
    Rational high;
  };
  /// p at t and a bound of its change over the interval: the step times sum i |p_i|.
  struct Change {
    mpz_class value;
    mpz_class off;
    long exponent;
  };
  static Change change(const IntegerPolynomial& p, const RootInterval& root) {
    if (p.empty()) return {0, 0, 0};
    const auto degree = static_cast<unsigned long>(p.size() - 1);
    mpz_class steep = 0;
    for (std::size_t i = 1; i < p.size(); ++i) steep += abs(p[i]) * static_cast<unsigned long>(i);
    mpz_class off = 0;
    if (!root.exact && degree > 0) off = steep << ((degree - 1) * root.t.shift);
    return {value_at(p, root.t), off, -static_cast<long>(degree * root.t.shift)};
  }
  /// Of the squared distance over 2^(2 exponent); empty where W may vanish in the interval.
  [[nodiscard]] std::optional<Range> range(const RootInterval& root) const {
    const auto square = change(problem_.squared, root);
    const auto weight = change(problem_.weight, root);
    const mpz_class size = abs(weight.value);
    if (size <= weight.off) return std::nullopt;
    const mpz_class least = size - weight.off;
    const mpz_class largest = size + weight.off;
    const mpz_class low = square.value > square.off ? mpz_class(square.value - square.off) : mpz_class(0);
    const long exponent = square.exponent - 2 * weight.exponent;
    return Range{{low, largest * largest, exponent}, {square.value + square.off, least * least, exponent}};
  }
  [[nodiscard]] bool is_narrow(const RootInterval& root, long bits) const {
    if (root.exact || is_among(zeros_, root)) return true;
    const auto known = range(root);
    if (!known || known->low.numerator == 0) return false;
    Rational width = known->high - known->low;
    width.exponent += bits;
    return less(width, known->low);
  }

  const Problem& problem_;
  const IntegerPolynomial& slope_;
  const IntegerPolynomial& zeros_;
};

/// The square root of b >= 0, cut to 256 bits.
Rational root_of(const Rational& b) {
  if (b.numerator == 0) return {};
  constexpr long root_bits = 256;
  const long drop = floor_log2(b) / 2 - root_bits;  // of the root
  const long shift = b.exponent - 2 * drop;
  mpz_class integer = shift >= 0 ? mpz_class((b.numerator << static_cast<mp_bitcnt_t>(shift)) / b.denominator)
                                 : mpz_class((b.numerator >> static_cast<mp_bitcnt_t>(-shift)) / b.denominator);
  return {sqrt(integer), 1, drop};
}

Rational largest_speed(const CurveView<double>& curve) {
  Rational largest;
  for (int i = 0; i < curve.degree; ++i) {
    Rational square;
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const auto difference = exactly(curve(axis, i + 1)) - exactly(curve(axis, i));
      square = square + difference * difference;
    }
    if (less(largest, square)) largest = square;
  }
  return exactly(curve.degree) * root_of(largest);
}

Rational largest_coordinate(const CurveView<double>& curve, std::span<const double> point) {
  double largest = 0;
  for (const auto values : {curve.coefficients, point})
    for (const double x : values) largest = std::max(largest, std::abs(x));
  return exactly(largest);
}

Dyadic dyadic(double t) {
  const Rational place = exactly(t);
  const bool whole = place.exponent >= 0;
  return {whole ? mpz_class(place.numerator << static_cast<mp_bitcnt_t>(place.exponent)) : place.numerator,
          whole ? 0 : static_cast<unsigned long>(-place.exponent)};
}

}  // namespace

ExactProjection projection(const CurveView<double>& curve, std::span<const double> point) {
  const auto problem = problem_of(curve, point);
  const bool is_point = problem.slope.empty();  // the curve
  const auto slope = is_point ? IntegerPolynomial{} : square_free(problem.slope);
  const auto zeros = common_zeros(problem);
  std::vector<RootInterval> roots{{{0, 0}, true}};
  for (const auto& root : is_point ? std::vector<RootInterval>{} : isolate_roots(slope))
    if (!root.exact || root.t.shift > 0) roots.push_back(root);  // else an end
  roots.push_back({{1, 0}, true});
  ExactProjection result{{},
                         0,
                         problem.squared,
                         problem.exponent,
                         problem.weight,
                         largest_speed(curve),
                         largest_coordinate(curve, point),
                         curve.degree};
  const NearestOfRational nearest_of_rational(problem, slope, zeros);
  for (auto& root : roots) {
    refine_root(slope, root);
    if (curve.form == Form::rational) nearest_of_rational.narrow(root, distance_bits);
    result.critical.push_back(critical_point(problem, root, zeros));
  }
  if (is_point) return result;
  if (curve.form == Form::rational) {
    for (std::size_t i = 1; i < roots.size(); ++i)
      if (nearest_of_rational.is_nearer(roots[i], roots[result.nearest])) result.nearest = i;
    return result;
  }
  Nearest nearest(problem, slope);
  // Where |C(t) - P| = |C(1 - t) - P| for all t, the first half has the first of all nearest points.
  const auto count = mirrored(problem.squared) == problem.squared ? (roots.size() + 1) / 2 : roots.size();
  for (std::size_t i = 1; i < count; ++i)
    if (nearest.is_nearer(roots[i], roots[result.nearest])) result.nearest = i;
  return result;
}

Rational ExactProjection::distance_squared_at(double t) const {
  return squared_at(squared, weight, exponent, dyadic(t));
}

double foot_residual(double t, const ExactProjection& exact) {
  if (!(t >= 0 && t <= 1)) return std::numeric_limits<double>::infinity();
  Rational slope = squared_at(derivative(exact.squared), {}, exact.exponent, dyadic(t));
  slope.exponent -= 1;  // (|C - P|^2)' / 2
  if ((t == 0 && slope.numerator >= 0) || (t == 1 && slope.numerator <= 0)) return 0;
  const Rational u{1, 1, -53};
  const Rational& speed = exact.largest_speed;
  const Rational unit = u * speed *
                        (root_of(exact.distance_squared_at(t)) + speed * exactly(t) +
                         exactly(2 * exact.degree) * u * exact.largest_coordinate);
  return slope.numerator == 0 ? 0 : quotient(error_format, abs(slope), unit);
}

double distance_error(const Format& format, double a, const Rational& b) {
  return round_to(format, abs(exactly(a) - root_of(b)));
}

double foot_error(const Format& format, double t, double distance, const ExactProjection& exact) {
  if (!std::isfinite(t) || !std::isfinite(distance)) return std::numeric_limits<double>::infinity();
  const auto& least = exact.foot().distance_squared;
  const double distance_part = distance_error(format, distance, least);
  const double place_part = round_to(format, abs(root_of(exact.distance_squared_at(t)) - root_of(least)));
  return place_part > 2 * distance_part ? place_part : distance_part;
}

}  // namespace bezierbench::reference
