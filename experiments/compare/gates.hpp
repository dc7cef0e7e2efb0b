// SPDX-License-Identifier: MIT
// Gates: what a change of a method must not do, decided row by row on what two bundles have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/compare/comparison.hpp"

namespace bezierbench::compare {

/// What a gate fails on. `any_change` is of a bit of a result, better or worse; the others are beyond a threshold.
enum class Gate { any_change, slower, less_accurate, costlier };

/// The word for a gate on the command line: `less-accurate`.
[[nodiscard]] std::string_view name(Gate gate);
/// Every gate, in the order in which they are reported.
[[nodiscard]] const std::vector<Gate>& gates();

enum class Ruling {
  passes,
  fails,
  undecided  ///< the interval of a ratio of times reaches over the threshold, or a time may not be compared
};

[[nodiscard]] std::string_view name(Ruling ruling);

/// What a gate says of one row.
struct Ruled {
  const Row* row;
  Ruling ruling;
  std::string why;  ///< in a few words; empty where it passes
};

/// A gate and its rows, in the order of the tables.
struct GateReport {
  Gate gate;
  const Comparison* comparison;
  double threshold;
  std::vector<Ruled> rows;

  [[nodiscard]] std::size_t count(Ruling ruling) const;
  /// `3 of 40 times are slower by more than 5 %; 2 more undecided`; empty where the gate does not fail.
  [[nodiscard]] std::string brief() const;
  /// The same with the names of both sides.
  [[nodiscard]] std::string finding() const;
};

/// The rulings of one gate. `threshold` is what a ratio may grow beyond 1: 0.05 for 5 %.
///   slower         of a time, the low end of Timed::judged is above 1 + threshold
///   less-accurate  of a result, a mean error is above 1 + threshold times what it was; or a largest error is, and the mean
///                  grew as well; or a largest error has more than doubled; or a bound, promise or guarantee broke
///   costlier       the instructions are above 1 + threshold times what they were
/// A change for the better fails none of the three. The comparison must outlive the report.
[[nodiscard]] GateReport rule(Gate gate, const Comparison& comparison, double threshold);

}  // namespace bezierbench::compare
