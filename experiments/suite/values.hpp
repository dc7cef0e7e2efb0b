// SPDX-License-Identifier: MIT
// What keys of a suite hold besides numbers, texts and forms of curves.
#pragma once

#include <compare>
#include <string>

#include "core/curve_view.hpp"

namespace bezierbench::suite {

enum class ScalarKind { float32, float64 };

/// What one timed call does: prepare and one point; one prepared point; a dependent chain; one curve, many t.
enum class Mode { one_shot, point, latency, batch };

struct Interval {
  double min = 0;
  double max = 1;
  friend auto operator<=>(const Interval&, const Interval&) = default;
};

/// Asks of a method's batch kernel a share of the peak or the time of another method, in every row that it is about.
struct Goal {
  std::string method = {};                  ///< id
  double share = 0;                         ///< of the target's peak, at least; 0: not asked
  std::string no_slower_than = {};          ///< id of a method, by its scalar kernel; empty: not asked
  ScalarKind scalar = ScalarKind::float64;  ///< of the rows, like the degrees
  int from_degree = 0;
  int to_degree = max_degree;
  bool needs_additions_beside = false;  ///< only where additions beside multiply-adds raise the peak
  friend auto operator<=>(const Goal&, const Goal&) = default;
};

}  // namespace bezierbench::suite
