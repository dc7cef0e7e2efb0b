// SPDX-License-Identifier: MIT
#include "reference/companion/float_easing.hpp"

#include <cmath>
#include <limits>

namespace bezierbench::reference {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64, "the bounds are those of a long double of 64 bits");

constexpr long double long_unit = 0x1p-64L;

long double long_double_cubic(long double p1, long double p2, long double t) {
  const long double s = 1 - t;
  return t * (3 * s * (s * p1 + t * p2) + t * t);
}

}  // namespace

FloatEasing::FloatEasing(float x1, float y1, float x2, float y2) : x1_(x1), y1_(y1), x2_(x2), y2_(y2) {}

long double FloatEasing::residual(long double t, long double x) const { return long_double_cubic(x1_, x2_, t) - x; }

std::optional<FloatEasing::Interval> FloatEasing::at(float given) {
  const long double x = given;
  const long double uncertain = 12 * long_unit * x;
  long double low = 0;
  long double high = 1;
  long double off = 0;
  long double slope = 0;
  for (int step = 0; step < 200; ++step) {
    off = residual(t_, x);
    const long double s = 1 - t_;
    slope = 3 * (s * s * x1_ + 2 * s * t_ * (x2_ - x1_) + t_ * t_ * (1 - x2_));
    if (std::fabs(off) <= uncertain) break;
    (off > 0 ? high : low) = t_;
    const long double next = t_ - off / slope;
    t_ = next > low && next < high ? next : low + (high - low) / 2;
  }
  if (!(slope > 0)) return std::nullopt;
  long double width = 2 * (std::fabs(off) + 2 * uncertain) / slope + 4 * long_unit * t_;
  const auto encloses = [&] {
    const bool is_after = t_ - width <= 0 || residual(t_ - width, x) < -uncertain;
    return is_after && (t_ + width >= 1 || residual(t_ + width, x) > uncertain);
  };
  for (int attempt = 0; !encloses(); ++attempt, width *= 16)
    if (attempt == 3) return std::nullopt;
  const long double last = std::fmin(t_ + width, 1.0L);
  const long double steepest = 3 * (std::fabs(y1_) + last * (2 * std::fabs(y2_ - y1_) + last * std::fabs(1 - y2_)));
  const long double y = long_double_cubic(y1_, y2_, t_);
  const long double error = 12 * long_unit * long_double_cubic(std::fabs(y1_), std::fabs(y2_), t_) +
                            1.02L * (width + 2 * long_unit * t_) * steepest;
  return Interval{y - error, y + error};
}

}  // namespace bezierbench::reference
