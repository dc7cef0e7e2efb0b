// SPDX-License-Identifier: MIT
// What is counted of methods that are asked for a tolerance and keep it, break it or refuse it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace bezierbench::studies {

struct Promises {
  std::uint64_t non_finite = 0;
  std::uint64_t non_converged = 0;
  std::uint64_t broken = 0;  ///< said to be within the tolerance, and is not
  std::uint64_t first_broken = std::numeric_limits<std::uint64_t>::max();  ///< trial
  std::uint64_t evaluations = 0;                                           ///< of all trials
  std::uint64_t most_evaluations = 0;                                      ///< of one

  void add(bool converged, std::int64_t evaluated) {
    const auto count = static_cast<std::uint64_t>(evaluated);
    evaluations += count;
    most_evaluations = std::max(most_evaluations, count);
    non_converged += converged ? 0 : 1;
  }

  /// `error` and `allowed` are absolute, the error rounded to 24 bits.
  static bool keeps(double error, double allowed) { return error <= allowed * (1 + 0x1p-20); }

  void judge(bool converged, double error, double allowed, std::uint64_t trial) {
    if (!converged || keeps(error, allowed)) return;
    ++broken;
    first_broken = std::min(first_broken, trial);
  }

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.non_finite, self.non_converged, self.broken, self.first_broken, self.evaluations, self.most_evaluations);
  }

  void merge(const Promises& other) {
    non_finite += other.non_finite;
    non_converged += other.non_converged;
    broken += other.broken;
    first_broken = std::min(first_broken, other.first_broken);
    evaluations += other.evaluations;
    most_evaluations = std::max(most_evaluations, other.most_evaluations);
  }
};

/// What blocks of trials gave in one cell: a Row for each tolerance and, within it, each method as the study chose
/// them.
template <class Row>
struct ToleranceRows {
  std::vector<Row> rows;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.rows);
  }

  void merge(const ToleranceRows& other) {
    if (other.rows.size() != rows.size()) throw std::invalid_argument("tallies of different cells");
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].merge(other.rows[k]);
  }
};

}  // namespace bezierbench::studies
