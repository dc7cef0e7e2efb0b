// SPDX-License-Identifier: MIT
// What blocks of trials gave for every method in one cell of a study of subdivision.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

/// Trials in which something happened.
struct TrialCount {
  std::uint64_t count = 0;
  std::uint64_t first = std::numeric_limits<std::uint64_t>::max();  ///< trial

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.count, self.first);
  }

  void add(std::uint64_t trial) {
    ++count;
    first = std::min(first, trial);
  }
  void merge(const TrialCount& other) {
    count += other.count;
    first = std::min(first, other.first);
  }
};

struct SubdivisionErrors {
  metric::Tally error;  ///< of control points
  metric::Tally error_u;
  double weight_error_u = 0;     ///< the largest
  double bound_u = 0;            ///< the largest of bound / (u p~) of a control point
  std::uint64_t bounded = 0;     ///< control points for which a bound is proved
  TrialCount violations;         ///< a point or weight is off by more than its bound
  TrialCount broken_promises;    ///< the method promises ends or a junction that it did not keep
  TrialCount junctions_apart;    ///< the last control point of left is not the first of right, bit for bit
  TrialCount ends_moved;         ///< an end of the curve is not that of its half, bit for bit
  TrialCount points_off;         ///< a point of a half is not that of the curve, within the bounds
  std::uint64_t middles = 0;     ///< trials in which that was asked
  std::uint64_t non_finite = 0;  ///< trials with a number that is not finite; nothing else is judged of them

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.error_u, self.weight_error_u, self.bound_u, self.bounded, self.violations,
          self.broken_promises, self.junctions_apart, self.ends_moved, self.points_off, self.middles, self.non_finite);
  }

  void merge(const SubdivisionErrors& other) {
    error.merge(other.error);
    error_u.merge(other.error_u);
    weight_error_u = std::max(weight_error_u, other.weight_error_u);
    bound_u = std::max(bound_u, other.bound_u);
    bounded += other.bounded;
    violations.merge(other.violations);
    broken_promises.merge(other.broken_promises);
    junctions_apart.merge(other.junctions_apart);
    ends_moved.merge(other.ends_moved);
    points_off.merge(other.points_off);
    middles += other.middles;
    non_finite += other.non_finite;
  }
};

struct SubdivisionTally {
  std::vector<SubdivisionErrors> methods;  ///< as the study chose them

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.methods);
  }

  void merge(const SubdivisionTally& other) {
    if (other.methods.size() != methods.size()) throw std::invalid_argument("tallies of different methods");
    for (std::size_t k = 0; k < methods.size(); ++k) methods[k].merge(other.methods[k]);
  }
};

}  // namespace bezierbench::studies
