// SPDX-License-Identifier: MIT
// Which of several methods are worth choosing when both time and error count.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::metric {

/// What one method costs and how wrong it was seen to be, on the same inputs as its rivals.
struct Tradeoff {
  Interval time;         ///< median with its interval, any unit
  double largest_error;  ///< the worst seen; infinite where a result was not finite
};

/// Whether a method lies on the front: `off` where a rival that is at least as right is certainly faster; `unresolved`
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

/// For each of the methods, against all others. Of two with the same median and error neither beats the other. Times
/// are known to their intervals only; errors are compared as they were seen, for the inputs are the same.
std::vector<Front> pareto_front(std::span<const Tradeoff> methods);

}  // namespace bezierbench::metric
