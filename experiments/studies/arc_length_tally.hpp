// SPDX-License-Identifier: MIT
// What blocks of trials gave for every tolerance and method in one cell of a study of arc lengths.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

struct LengthErrors {
  metric::Tally error;     ///< in coordinate units
  metric::Tally relative;  ///< to the true length
  std::uint64_t non_finite = 0;
  std::uint64_t non_converged = 0;
  std::uint64_t broken = 0;  ///< said to be within the tolerance, and is not
  std::uint64_t first_broken = std::numeric_limits<std::uint64_t>::max();  ///< trial
  std::uint64_t evaluations = 0;                                           ///< of all trials
  std::uint64_t most_evaluations = 0;                                      ///< of one

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.relative, self.non_finite, self.non_converged, self.broken, self.first_broken,
          self.evaluations, self.most_evaluations);
  }

  void merge(const LengthErrors& other) {
    error.merge(other.error);
    relative.merge(other.relative);
    non_finite += other.non_finite;
    non_converged += other.non_converged;
    broken += other.broken;
    first_broken = std::min(first_broken, other.first_broken);
    evaluations += other.evaluations;
    most_evaluations = std::max(most_evaluations, other.most_evaluations);
  }
};

struct ArcLengthTally {
  std::vector<LengthErrors> rows;  ///< tolerance by tolerance, methods as the study chose them

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.rows);
  }

  void merge(const ArcLengthTally& other) {
    if (other.rows.size() != rows.size()) throw std::invalid_argument("tallies of different cells");
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].merge(other.rows[k]);
  }
};

}  // namespace bezierbench::studies
