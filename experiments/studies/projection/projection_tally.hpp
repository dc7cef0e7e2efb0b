// SPDX-License-Identifier: MIT
// What is kept of one method for point projection.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

struct ProjectionTally {
  metric::Tally error;       ///< of the distance, in coordinate units
  metric::Tally error_unit;  ///< of the distance, in 2^-52 times the largest coordinate
  metric::Tally t_error;     ///< from the nearest foot point that is as near as the nearest
  std::uint64_t missed = 0;
  std::uint64_t candidates = 0;
  std::uint64_t most_candidates = 0;
  std::uint64_t non_converged = 0;
  std::uint64_t non_finite = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.error_unit, self.t_error, self.missed, self.candidates, self.most_candidates,
          self.non_converged, self.non_finite);
  }

  void merge(const ProjectionTally& other) {
    error.merge(other.error);
    error_unit.merge(other.error_unit);
    t_error.merge(other.t_error);
    missed += other.missed;
    candidates += other.candidates;
    most_candidates = std::max(most_candidates, other.most_candidates);
    non_converged += other.non_converged;
    non_finite += other.non_finite;
  }
};

/// One for each method.
struct ProjectionTallies {
  std::vector<ProjectionTally> methods;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.methods);
  }

  void merge(const ProjectionTallies& other) {
    methods.resize(std::max(methods.size(), other.methods.size()));
    for (std::size_t m = 0; m < other.methods.size(); ++m) methods[m].merge(other.methods[m]);
  }
};

}  // namespace bezierbench::studies
