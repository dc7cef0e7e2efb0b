// SPDX-License-Identifier: MIT
// The methods on the Pareto front of time and error.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::metric {

/// The time of one method and its observed maximum error, on the same inputs as its rivals.
struct Tradeoff {
  Interval time;         ///< median with its interval, any unit
  double largest_error;  ///< observed maximum; infinite where a result was not finite
};

/// Whether a method lies on the front: `off` where a rival whose error is no larger is certainly faster; `unresolved`
/// where such a rival is faster by its median, but the intervals of the two times overlap; else `on`.
enum class Front { on, off, unresolved };

constexpr std::string_view name(Front front) {
  switch (front) {
    case Front::on: return "yes";
    case Front::off: return "no";
    case Front::unresolved: return "unresolved";
  }
  return "";
}

/// Compares each method with all others. Of two with the same median and error neither beats the other. Times are
/// compared by their intervals. Observed errors are compared directly, because the inputs are the same.
std::vector<Front> pareto_front(std::span<const Tradeoff> methods);

}  // namespace bezierbench::metric
