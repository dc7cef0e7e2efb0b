// SPDX-License-Identifier: MIT
// Types of the values of a suite's keys, other than numbers, texts and forms of curves.
#pragma once

#include <compare>
#include <string>

#include "core/curve_view.hpp"

namespace bezierbench::suite {

enum class ScalarKind { float32, float64 };

/// What one timed call does: prepare and one point; one prepared point; a dependent chain of points; one curve at many
/// t.
enum class Mode { one_shot, point, latency, batch };

struct Interval {
  double min = 0;
  double max = 1;
  friend auto operator<=>(const Interval&, const Interval&) = default;
};

/// A goal for a method's batch kernel: a share of the peak, or the time of another method, in every row that it applies
/// to.
struct Goal {
  std::string method = {};                  ///< id of the method
  double share = 0;                         ///< least share of the target's peak; 0: no such goal
  std::string no_slower_than = {};          ///< id of a method, timed by its scalar kernel; empty: no such goal
  ScalarKind scalar = ScalarKind::float64;  ///< scalar of the rows; degrees likewise
  int from_degree = 0;
  int to_degree = max_degree;
  bool needs_additions_beside = false;  ///< only on targets whose peak rises with additions beside multiply-adds
  friend auto operator<=>(const Goal&, const Goal&) = default;
};

}  // namespace bezierbench::suite
