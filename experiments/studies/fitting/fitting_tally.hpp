// SPDX-License-Identifier: MIT
// What blocks of trials gave for every tolerance and fitting method on one kind of data in one cell.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

/// Distances are the largest of a data set.
struct FitErrors {
  metric::Tally error;    ///< true, in coordinate units
  metric::Tally claimed;  ///< by the method, in coordinate units
  std::uint64_t non_finite = 0;
  std::uint64_t non_converged = 0;
  std::uint64_t broken = 0;       ///< said to be within the tolerance, and is not
  std::uint64_t understated = 0;  ///< farther than claimed
  std::uint64_t first_broken = std::numeric_limits<std::uint64_t>::max();  ///< trial
  std::uint64_t segments = 0;                                              ///< of all trials
  std::uint64_t most_segments = 0;                                         ///< of one
  std::uint64_t one_segment = 0;                                           ///< trials that need no more
  std::uint64_t iterations = 0;
  std::uint64_t most_iterations = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.claimed, self.non_finite, self.non_converged, self.broken, self.understated,
          self.first_broken, self.segments, self.most_segments, self.one_segment, self.iterations,
          self.most_iterations);
  }

  void merge(const FitErrors& other) {
    error.merge(other.error);
    claimed.merge(other.claimed);
    non_finite += other.non_finite;
    non_converged += other.non_converged;
    broken += other.broken;
    understated += other.understated;
    first_broken = std::min(first_broken, other.first_broken);
    segments += other.segments;
    most_segments = std::max(most_segments, other.most_segments);
    one_segment += other.one_segment;
    iterations += other.iterations;
    most_iterations = std::max(most_iterations, other.most_iterations);
  }
};

struct FittingTally {
  std::vector<FitErrors> rows;  ///< tolerance by tolerance, methods as the study chose them

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.rows);
  }

  void merge(const FittingTally& other) {
    if (other.rows.size() != rows.size()) throw std::invalid_argument("tallies of different cells");
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].merge(other.rows[k]);
  }
};

}  // namespace bezierbench::studies
