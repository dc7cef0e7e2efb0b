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
// in several repetitions (experiments/race/repetition.hpp): what changes from one repetition to the next also changes
// from one run to the next.
#pragma once

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::compare {

/// The ratio b / a with its interval. Medians and limits must be positive; the result is NaN where they are not.
metric::Interval ratio(const metric::Interval& b, const metric::Interval& a);

/// The same ratio with each time in units of another time of its own run: (b / b_unit) over (a / a_unit).
metric::Interval ratio_in_units(const metric::Interval& b, const metric::Interval& b_unit, const metric::Interval& a,
                                const metric::Interval& a_unit);

}  // namespace bezierbench::compare
