// SPDX-License-Identifier: MIT
#include "reference/companion/exact_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/companion/integer_polynomial.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest double that is not above x.
double rounded_down(const Rational& x) {
  const double nearest = round_to(binary64, x);
  return less(x, exactly(nearest)) ? std::nextafter(nearest, -infinity) : nearest;
}

/// The smallest double that is not below x.
double rounded_up(const Rational& x) {
  const double nearest = round_to(binary64, x);
  return less(exactly(nearest), x) ? std::nextafter(nearest, infinity) : nearest;
}

/// N, W and N'W - NW' of one axis.
class Fraction {
 public:
  Fraction(const CurveView<double>& curve, int axis) {
    const int n = curve.degree;
    std::vector<Rational> points;
    std::vector<Rational> weights;
    for (int i = 0; i <= n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double w = curve.form == Form::rational ? curve.weights[k] : 1;
      weights.push_back(exactly(w));
      points.push_back(exactly(curve(axis, i)) * weights.back());
      least_weight_ = i == 0 ? w : std::min(least_weight_, w);
    }
    numerator_ = from_bernstein(points, exponent_);
    denominator_ = from_bernstein(weights, weight_exponent_);
    slope_ = difference(product(derivative(numerator_), denominator_), product(numerator_, derivative(denominator_)));
    mpz_class sum = 0;
    for (const auto& c : slope_) sum += abs(c);
    const auto least = exactly(least_weight_);
    // (N/W)' = slope / W^2 with W at least the least weight.
    steepest_ = {sum * least.denominator * least.denominator, least.numerator * least.numerator,
                 exponent_ + weight_exponent_ - 2 * least.exponent};
  }

  [[nodiscard]] const IntegerPolynomial& slope() const { return slope_; }

  /// N / W at the beginning of an interval of t, and how far the value at the root may be from it.
  struct Enclosed {
    Rational value;
    Rational off;
  };
  [[nodiscard]] Enclosed at(const RootInterval& root) const {
    Rational off = steepest_;
    off.exponent -= static_cast<long>(root.t.shift);
    if (root.exact) off = {};
    const auto shift = static_cast<long>(root.t.shift);
    const auto degree = [](const IntegerPolynomial& p) { return static_cast<long>(p.size()) - 1; };
    if (numerator_.empty()) return {{}, off};
    return {{value_at(numerator_, root.t), value_at(denominator_, root.t),
             exponent_ - weight_exponent_ - shift * (degree(numerator_) - degree(denominator_))},
            off};
  }

  /// Whether N / W is c at the root.
  [[nodiscard]] bool is_at(const RootInterval& root, double c) const {
    const auto exact = exactly(c);
    const auto lowest = std::min(exponent_, weight_exponent_ + exact.exponent);
    const auto times = [](IntegerPolynomial p, const mpz_class& factor, long exponent) {
      for (auto& term : p) term = (term * factor) << static_cast<mp_bitcnt_t>(exponent);
      return p;
    };
    const auto off = difference(times(numerator_, 1, exponent_ - lowest),
                                times(denominator_, exact.numerator, weight_exponent_ + exact.exponent - lowest));
    const auto common = greatest_common_divisor(off, slope_);
    if (common.size() < 2) return false;
    const auto once = square_free(common);
    return sign_at(once, root.t) * sign_at(once, {root.t.k + 1, root.t.shift}) < 0;
  }

 private:
  IntegerPolynomial numerator_;
  IntegerPolynomial denominator_;
  IntegerPolynomial slope_;
  long exponent_ = 0;         ///< of the numerator
  long weight_exponent_ = 0;  ///< of the denominator
  double least_weight_ = 0;
  Rational steepest_;
};

/// Extends the range to the value at a root of the slope, which `p` is without multiple roots.
void include(const Fraction& fraction, const IntegerPolynomial& p, RootInterval root, ExactRange& range) {
  constexpr unsigned long first_bits = 64;
  constexpr unsigned long bits_before_comparison = 256;
  for (unsigned long bits = first_bits;; bits *= 2) {
    refine(p, root, bits);
    const auto [value, off] = fraction.at(root);
    const Rational low = value - off;
    const Rational high = value + off;
    if (!less(low, exactly(range.low)) && !less(exactly(range.high), high)) return;
    const double floor = rounded_down(low);
    const double floor_of_high = rounded_down(high);
    if (floor == floor_of_high && (root.exact || less(exactly(floor), low))) {
      range.low = std::min(range.low, floor);
      range.high = std::max(range.high, rounded_up(high));
      return;
    }
    if (bits >= bits_before_comparison && fraction.is_at(root, floor_of_high)) {
      range.low = std::min(range.low, floor_of_high);
      range.high = std::max(range.high, floor_of_high);
      return;
    }
  }
}

}  // namespace

ExactRange exact_range(const CurveView<double>& curve, int axis) {
  const double start = curve(axis, 0);
  const double end = curve(axis, curve.degree);
  ExactRange range{std::min(start, end), std::max(start, end)};
  const Fraction fraction(curve, axis);
  if (fraction.slope().empty()) return range;
  const auto slope = square_free(fraction.slope());
  for (const auto& root : isolate_roots(slope)) include(fraction, slope, root, range);
  return range;
}

}  // namespace bezierbench::reference
