// SPDX-License-Identifier: MIT
#include "reference/companion/exact_roots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/companion/integer_polynomial.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

namespace {

Rational weight(const CurveView<double>& curve, int i) {
  return exactly(curve.form == Form::rational ? curve.weights[static_cast<std::size_t>(i)] : 1);
}

/// The polynomial, over a power of two, with these coefficients in the form of the curve.
IntegerPolynomial polynomial(Form form, const std::vector<Rational>& coefficients) {
  long exponent = 0;
  if (form != Form::power) return from_bernstein(coefficients, exponent);
  exponent = std::ranges::min(coefficients, {}, &Rational::exponent).exponent;
  IntegerPolynomial p;
  for (const auto& c : coefficients) p.emplace_back(c.numerator << static_cast<mp_bitcnt_t>(c.exponent - exponent));
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

IntegerPolynomial numerator(const CurveView<double>& curve, int axis) {
  std::vector<Rational> coefficients;
  for (int i = 0; i <= curve.degree; ++i) coefficients.push_back(exactly(curve(axis, i)) * weight(curve, i));
  return polynomial(curve.form, coefficients);
}

IntegerPolynomial denominator(const CurveView<double>& curve) {
  if (curve.form != Form::rational) return {1};
  std::vector<Rational> coefficients;
  for (int i = 0; i <= curve.degree; ++i) coefficients.push_back(weight(curve, i));
  return polynomial(curve.form, coefficients);
}

/// A root of a square-free factor; factors have no root in common.
struct FactorRoot {
  const IntegerPolynomial* factor;
  RootInterval root;
  int multiplicity;
};

constexpr unsigned long first_bits = 64;

/// The root rounded to double: narrows its interval until both ends round to the same number.
double rounded(FactorRoot& found) {
  auto& root = found.root;
  for (unsigned long bits = first_bits;; bits *= 2) {
    refine(*found.factor, root, bits);
    const auto exponent = -static_cast<long>(root.t.shift);
    const double low = round_to(binary64, {root.t.k, 1, exponent});
    if (root.exact || low == round_to(binary64, {root.t.k + 1, 1, exponent})) return low;
  }
}

/// Whether a is left of b, which is another root; narrows both until their intervals are apart.
bool is_before(FactorRoot& a, FactorRoot& b) {
  const auto end = [](const FactorRoot& found) { return found.root.t.k + (found.root.exact ? 0 : 1); };
  const auto not_after = [](const mpz_class& x, const Dyadic& of_x, const mpz_class& y, const Dyadic& of_y) {
    return mpz_class(x << of_y.shift) <= mpz_class(y << of_x.shift);
  };
  for (unsigned long bits = first_bits;; bits *= 2) {
    if (not_after(end(a), a.root.t, b.root.t.k, b.root.t)) return true;
    if (not_after(end(b), b.root.t, a.root.t.k, a.root.t)) return false;
    refine(*a.factor, a.root, bits);
    refine(*b.factor, b.root, bits);
  }
}

Roots roots_of(const IntegerPolynomial& p) {
  if (p.empty()) return {.everywhere = true, .roots = {}};
  const auto factors = square_free_factors(p);
  std::vector<FactorRoot> all;
  for (std::size_t k = 0; k < factors.size(); ++k)
    for (const auto& root : isolate_roots(factors[k])) all.push_back({&factors[k], root, static_cast<int>(k) + 1});
  std::vector<FactorRoot*> ascending;
  for (auto& root : all)
    ascending.insert(std::ranges::find_if(ascending, [&](auto* other) { return is_before(root, *other); }), &root);
  Roots found;
  for (auto* root : ascending) found.roots.push_back({rounded(*root), root->multiplicity});
  return found;
}

}  // namespace

Roots roots_of_value(const CurveView<double>& curve, int axis, double value) {
  std::vector<Rational> coefficients;
  for (int i = 0; i <= curve.degree; ++i) {
    const bool moves = curve.form != Form::power || i == 0;
    const auto moved = moves ? exactly(curve(axis, i)) - exactly(value) : exactly(curve(axis, i));
    coefficients.push_back(moved * weight(curve, i));
  }
  return roots_of(polynomial(curve.form, coefficients));
}

Roots roots_of_derivative(const CurveView<double>& curve, int axis) {
  const auto n = numerator(curve, axis);
  const auto w = denominator(curve);
  return roots_of(difference(product(derivative(n), w), product(n, derivative(w))));
}

Roots roots_of_curvature(const CurveView<double>& curve) {
  const IntegerPolynomial rows[] = {numerator(curve, 0), numerator(curve, 1), denominator(curve)};
  IntegerPolynomial determinant;
  for (int k = 0; k < 3; ++k) {  // along the column P
    const auto first = derivative(rows[(k + 1) % 3]);
    const auto second = derivative(rows[(k + 2) % 3]);
    const auto minor = difference(product(derivative(first), second), product(first, derivative(second)));
    determinant = difference(determinant, product(rows[k], minor));
  }
  return roots_of(determinant);
}

std::optional<double> pole(const CurveView<double>& curve, double from, double to) {
  if (curve.form != Form::rational) return std::nullopt;
  if (std::ranges::all_of(curve.weights, [](double w) { return w > 0; })) return std::nullopt;
  if (std::ranges::all_of(curve.weights, [](double w) { return w < 0; })) return std::nullopt;
  std::vector<Rational> weights;
  for (const double w : curve.weights) weights.push_back(exactly(w));
  long exponent = 0;
  const auto denominator = from_bernstein(weights, exponent);
  if (denominator.empty()) return from;
  const auto p = square_free(denominator);
  constexpr unsigned long bits_of_a_double = 1075;  // every double in [0, 1] is an end of such an interval
  for (auto root : isolate_roots(p)) {
    refine(p, root, bits_of_a_double);
    const Rational low{root.t.k, 1, -static_cast<long>(root.t.shift)};
    const Rational high{root.t.k + (root.exact ? 0 : 1), 1, low.exponent};
    if (!less(low, exactly(from)) && !less(exactly(to), high)) return round_to(binary64, low);
  }
  return std::nullopt;
}

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
