// SPDX-License-Identifier: MIT
#include "reference/companion/float_easing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bezierbench::reference {
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
