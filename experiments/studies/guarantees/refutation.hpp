// SPDX-License-Identifier: MIT
// What random inputs and a search find out about one statement and one method.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"

namespace bezierbench::studies {

/// An input and its measure, in numbers that hold every scalar type.
struct RecordedCase {
  double measure = 0;  ///< of a counterexample its size, of an attempt its excess
  double t = 0;
  double t_next = 0;
  double offset = 0;
  std::vector<double> coefficients;  ///< point by point

  template <class Scalar>
  static RecordedCase of(const guarantees::Case<Scalar>& input, double measure) {
    return {measure,
            static_cast<double>(input.t),
            static_cast<double>(input.t_next),
            static_cast<double>(input.offset),
            {input.coefficients.begin(), input.coefficients.end()}};
  }
  friend bool operator<(const RecordedCase& a, const RecordedCase& b) {
    return std::tie(a.measure, a.t, a.t_next, a.offset, a.coefficients) <
           std::tie(b.measure, b.t, b.t_next, b.offset, b.coefficients);
  }

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.measure, self.t, self.t_next, self.offset, self.coefficients);
  }
};

/// The sum over blocks, in any order.
struct Refutation {
  std::uint64_t trials = 0;              ///< random inputs that the statement is about
  std::uint64_t broken = 0;              ///< of these
  std::uint64_t searched = 0;            ///< further inputs that were tried
  std::optional<RecordedCase> smallest;  ///< that breaks the property
  std::optional<RecordedCase> nearest;   ///< of all inputs the one with the largest excess

  void merge(const Refutation& other) {
    trials += other.trials;
    broken += other.broken;
    searched += other.searched;
    if (other.smallest) add_counterexample(*other.smallest);
    if (other.nearest) add_attempt(*other.nearest);
  }
  void add_counterexample(const RecordedCase& found) {
    if (!smallest || found < *smallest) smallest = found;
  }
  /// Of equal excess, the first in their order.
  void add_attempt(const RecordedCase& found) {
    if (!nearest || found.measure > nearest->measure || (found.measure == nearest->measure && found < *nearest))
      nearest = found;
  }

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.trials, self.broken, self.searched, self.smallest, self.nearest);
  }
};

}  // namespace bezierbench::studies
