// SPDX-License-Identifier: MIT
// The ratio of two times with its interval, where each time is known by its median and an interval only.
//
// Recovery of variance estimates (MOVER), on logarithms. A run's interval [l, u] around its median m says how far the
// median may be off in each direction: log(m/l) below and log(u/m) above, whatever the distribution. For a difference
// of independent estimates these distances add in squares, the lower one of the first with the upper one of the second
// (Zou and Donner 2008, Statistics in Medicine 27:1693, section 2; Donner and Zou 2012, Statistical Methods in Medical
// Research 21:347, for ratios). With x = log b and y = log a, log(b/a) = x - y lies in
//
//     [x - y - sqrt(log(b/b_low)^2 + log(a_high/a)^2),  x - y + sqrt(log(b_high/b)^2 + log(a/a_low)^2)]
//
// at the confidence of the two intervals. The intervals cover what varied within each run. Each time is therefore taken
// in several repetitions (experiments/race/race.hpp): what changes from one repetition to the next also changes
// from one run to the next.
#pragma once

#include <cmath>
#include <limits>

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::compare {

/// The ratio b / a with its interval. Medians and limits must be positive; the interval is NaN where they are not.
inline metric::Interval ratio(const metric::Interval& b, const metric::Interval& a) {
  const auto distance = [](double low, double high) {
    return low > 0 && low <= high ? std::log(high / low) : std::numeric_limits<double>::quiet_NaN();
  };
  const auto root_of_squares = [](double x, double y) { return std::sqrt(x * x + y * y); };
  const double median = b.median / a.median;
  const double below = root_of_squares(distance(b.low, b.median), distance(a.median, a.high));
  const double above = root_of_squares(distance(b.median, b.high), distance(a.low, a.median));
  return {median, median * std::exp(-below), median * std::exp(above)};
}

}  // namespace bezierbench::compare
