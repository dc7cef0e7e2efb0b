// SPDX-License-Identifier: MIT
#include "reference/companion/easing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <tuple>
#include <vector>

namespace bezierbench::reference {

namespace {

constexpr unsigned long first_root_bits = 192;

/// x 2^-exponent, an integer.
mpz_class scaled_integer(double x, long exponent) {
  const auto exact = exactly(x);
  if (exact.numerator == 0) return 0;
  return exact.numerator << static_cast<mp_bitcnt_t>(exact.exponent - exponent);
}

long lowest_exponent_of(std::initializer_list<double> values) {
  long lowest = exactly(1).exponent;  // that of the last point
  for (const double value : values) lowest = std::min(lowest, exactly(value).exponent);
  return lowest;
}

/// p1 3 t (1-t)^2 + p2 3 t^2 (1-t) + t^3 - value, times 2^-exponent.
IntegerPolynomial easing_cubic(double p1, double p2, const Rational& value, long exponent) {
  const mpz_class less = value.numerator == 0
                             ? mpz_class(0)
                             : mpz_class(value.numerator << static_cast<mp_bitcnt_t>(value.exponent - exponent));
  return from_scaled_bernstein({-less, 3 * (scaled_integer(p1, exponent) - less),
                                3 * (scaled_integer(p2, exponent) - less), scaled_integer(1, exponent) - less});
}

/// The slope of the line beyond an end that is the origin: through the nearer inner point or, where that is the end,
/// the other one; 0 where it is vertical, 1 where both are the end.
Rational slope_beyond(const Rational& near_x, const Rational& near_y, const Rational& far_x, const Rational& far_y) {
  const auto is_end = [](const Rational& x, const Rational& y) { return x.numerator == 0 && y.numerator == 0; };
  if (is_end(near_x, near_y) && is_end(far_x, far_y)) return exactly(1);
  const auto& [x, y] = is_end(near_x, near_y) ? std::tie(far_x, far_y) : std::tie(near_x, near_y);
  if (x.numerator == 0) return {};
  const int sign = sgn(x.numerator);
  return {sign * y.numerator * x.denominator, sign * x.numerator * y.denominator, y.exponent - x.exponent};
}

Rational middle_of(double a, double b) {
  auto sum = exactly(a) + exactly(b);
  --sum.exponent;
  return sum;
}

}  // namespace

ExactEased::ExactEased(double x1, double y1, double x2, double y2, double x) : exponent_(lowest_exponent_of({y1, y2})) {
  if (x < 0 || x > 1) {
    const auto end = exactly(x < 0 ? 0 : 1);
    const auto from_end = [&](double value) { return exactly(value) - end; };
    const Rational slope = x < 0 ? slope_beyond(from_end(x1), from_end(y1), from_end(x2), from_end(y2))
                                 : slope_beyond(from_end(x2), from_end(y2), from_end(x1), from_end(y1));
    root_.t.k = end.numerator == 0 ? 0 : 1;
    set(slope * from_end(x) + end);
    return;
  }
  x_ = easing_cubic(x1, x2, exactly(x), lowest_exponent_of({x1, x2, x}));
  simple_ = square_free(x_);
  y_ = easing_cubic(y1, y2, {}, exponent_);
  const mpz_class first = scaled_integer(y1, exponent_);
  const mpz_class second = scaled_integer(y2, exponent_);
  const mpz_class one = scaled_integer(1, exponent_);
  steepest_ = 3 * std::max({mpz_class(abs(first)), mpz_class(abs(second - first)), mpz_class(abs(one - second))});
  root_ = isolate_roots(simple_).front();
  refine(simple_, root_, first_root_bits);
  enclose();
  const Rational number = exactly(nearest(binary64));
  if (is(number)) set(number);
}

void ExactEased::enclose() {
  const auto degree = y_.empty() ? 0 : static_cast<long>(y_.size()) - 1;
  const auto shift = static_cast<long>(root_.t.shift);
  low_ = {value_at(y_, root_.t), 1, exponent_ - degree * shift};
  high_ = low_;
  if (root_.exact) return set(low_);
  const Rational reach{steepest_, 1, exponent_ - shift};
  low_ = low_ - reach;
  high_ = high_ + reach;
}

void ExactEased::narrow() {
  refine(simple_, root_, 2 * root_.t.shift);
  enclose();
}

void ExactEased::set(const Rational& value) {
  low_ = high_ = value;
  is_exact_ = true;
}

bool ExactEased::is(const Rational& value) const {
  const long exponent = std::min(exponent_, value.numerator == 0 ? 0 : value.exponent);
  auto difference = y_;
  for (auto& c : difference) c <<= static_cast<mp_bitcnt_t>(exponent_ - exponent);
  if (difference.empty()) difference.emplace_back(0);
  if (value.numerator != 0) difference[0] -= value.numerator << static_cast<mp_bitcnt_t>(value.exponent - exponent);
  while (!difference.empty() && difference.back() == 0) difference.pop_back();
  const auto common = greatest_common_divisor(x_, difference);
  return common.size() > 1 && !isolate_roots(square_free(common)).empty();
}

double ExactEased::t() const { return round_to(binary64, {root_.t.k, 1, -static_cast<long>(root_.t.shift)}); }

double ExactEased::nearest(const Format& format) {
  for (bool is_first = true;; is_first = false) {
    const double below = round_to(format, low_);
    const double above = round_to(format, high_);
    if (below == above) return below;
    if (is_first && is(middle_of(below, above)))
      set(middle_of(below, above));  // a tie, unless numbers are between them
    if (!is_exact_) narrow();
  }
}

double ExactEased::error(double value) {
  const Rational number = exactly(value);
  for (bool is_first = true;; is_first = false) {
    const double at_low = round_to(error_format, abs(number - low_));
    const double at_high = round_to(error_format, abs(number - high_));
    const bool is_inside = less(low_, number) && less(number, high_);
    if (at_low == at_high && !is_inside) return at_low;
    if (is_first)
      for (const Rational& place : {number - middle_of(at_low, at_high), number + middle_of(at_low, at_high)})
        if (!is_exact_ && is(place)) set(place);
    if (!is_exact_) narrow();
  }
}

double ExactEased::error_ulp(double value, const Format& format) {
  const double absolute = error(value);
  if (is_exact_ && low_.numerator == 0) return std::ldexp(absolute, static_cast<int>(-format.lowest_exponent));
  while (!is_exact_ && (sgn(low_.numerator) * sgn(high_.numerator) <= 0 || floor_log2(low_) != floor_log2(high_)))
    narrow();
  const long exponent = std::max(floor_log2(low_) - (format.precision - 1), format.lowest_exponent);
  return std::ldexp(absolute, static_cast<int>(-exponent));
}

namespace {

static_assert(std::numeric_limits<long double>::digits >= 64, "the bounds are those of a long double of 64 bits");

template <class Number>
Number cubic(Number p1, Number p2, Number t) {
  const Number s = 1 - t;
  return t * (3 * s * (s * p1 + t * p2) + t * t);
}

}  // namespace

bool FloatEasing::Interval::decides() const {
  const auto binade = [](double y) { return std::bit_cast<std::uint64_t>(y) >> 52U; };  // with the sign
  return static_cast<float>(low) == static_cast<float>(high) && low != 0 && binade(low) == binade(high) &&
         high - low <= 0x1p-46 * std::abs(low);
}

FloatEasing::FloatEasing(float x1, float y1, float x2, float y2)
    : in_double_{x1, y1, x2, y2}, in_long_double_{x1, y1, x2, y2} {}

std::optional<FloatEasing::Interval> FloatEasing::at(float x) {
  constexpr int most_steps_in_double = 6;
  constexpr int most_steps = 200;
  if (const auto found = at<double>(in_double_, x, most_steps_in_double); found && found->decides()) return found;
  return at<long double>(in_long_double_, x, most_steps);
}

template <class Number>
std::optional<FloatEasing::Interval> FloatEasing::at(const Curve<Number>& curve, Number x, int most_steps) {
  constexpr Number unit = std::numeric_limits<Number>::epsilon() / 2;
  const auto& [x1, y1, x2, y2] = curve;
  const auto residual = [&curve, x](Number at) { return cubic(curve.x1, curve.x2, at) - x; };
  const Number uncertain = 12 * unit * x;
  Number low = 0;
  Number high = 1;
  Number off = 0;
  Number slope = 0;
  Number t = t_ + (t_ - t_before_);
  if (!(t > 0 && t < 1)) t = t_;
  for (int step = 0; step < most_steps; ++step) {
    off = residual(t);
    const Number s = 1 - t;
    slope = 3 * (s * s * x1 + 2 * s * t * (x2 - x1) + t * t * (1 - x2));
    if (std::abs(off) <= uncertain) break;
    (off > 0 ? high : low) = t;
    const Number next = t - off / slope;
    t = next > low && next < high ? next : low + (high - low) / 2;
  }
  t_before_ = t_;
  t_ = static_cast<double>(t);
  if (!(slope > 0)) return std::nullopt;
  Number width = 2 * (std::abs(off) + uncertain) / slope + 4 * unit * t;
  const auto encloses = [&] {
    const bool is_after = t - width <= 0 || residual(t - width) < -uncertain;
    return is_after && (t + width >= 1 || residual(t + width) > uncertain);
  };
  for (int attempt = 0; !encloses(); ++attempt, width *= 16)
    if (attempt == 3) return std::nullopt;
  const Number last = std::min(t + width, Number(1));
  const Number steepest = 3 * (std::abs(y1) + last * (2 * std::abs(y2 - y1) + last * std::abs(1 - y2)));
  const Number y = cubic(y1, y2, t);
  const Number error =
      12 * unit * cubic(std::abs(y1), std::abs(y2), t) + Number(1.02) * (width + 2 * unit * t) * steepest;
  // Outwards, since the ends are rounded, in long double twice.
  const Number reach = error + std::abs(y) * Number(0x1p-52);
  return Interval{static_cast<double>(y - reach), static_cast<double>(y + reach)};
}

}  // namespace bezierbench::reference
