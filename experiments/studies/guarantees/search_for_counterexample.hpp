// SPDX-License-Identifier: MIT
// A block of trials of one statement and one method: random inputs, and the search for a counterexample, the smaller the
// better.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/draws.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/statements.hpp"
#include "experiments/run/interruption.hpp"

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

template <class Scalar>
class CounterexampleSearch {
 public:
  CounterexampleSearch(const guarantees::Statement<Scalar>& statement, const Kernel<Scalar>& kernel, int degree)
      : statement_(statement), method_(kernel), axes_(statement.axes(kernel.dimension)) {
    input_.dimension = kernel.dimension;
    input_.coefficients.resize(static_cast<std::size_t>((degree + 1) * kernel.dimension));
  }

  /// A random input, which is counted. Its control points are `given`, if any are.
  void add_trial(sample::Words& words, std::span<const double> given) {
    guarantees::Draws<Scalar>(words).full(input_, axes_);
    const auto dimension = static_cast<std::size_t>(input_.dimension);
    for (std::size_t k = 0; k < given.size(); ++k)
      if (k % dimension < static_cast<std::size_t>(axes_)) input_.coefficients[k] = static_cast<Scalar>(given[k]);
    const auto excess = judged(input_);
    if (!excess) return;
    ++found_.trials;
    if (*excess > 0) ++found_.broken;
  }

  /// Special inputs, until they were tried with half of the budget or enough of them break the property; then, where
  /// none did, steps from input to input that do not lead away from breaking it. Last, what was found is made smaller.
  void search(sample::Words& words, std::int64_t budget) {
    guarantees::Draws<Scalar> draws(words);
    std::int64_t tried = 0;
    for (int broken = 0; tried < budget / 2 && broken < enough && !run::interrupted(); ++tried) {
      draws.special(input_, axes_);
      const auto excess = judged(input_);
      if (excess && *excess > 0) ++broken;
    }
    if (!smallest_) tried += climb(draws, budget - tried);
    if (smallest_) tried += make_smaller();
    found_.searched += static_cast<std::uint64_t>(tried);
  }

  [[nodiscard]] Refutation result() && {
    if (smallest_) found_.add_counterexample(RecordedCase::of(*smallest_, static_cast<double>(size_)));
    return std::move(found_);
  }

 private:
  using Case = guarantees::Case<Scalar>;
  static constexpr int enough = 64;             ///< counterexamples to choose the smallest from
  static constexpr int max_tries = 4000;        ///< to make one smaller
  static constexpr std::int64_t restart = 256;  ///< steps from one special input

  [[nodiscard]] std::int64_t size(const Case& input) const {
    return guarantees::size_of(input, statement_.uses_t_next, statement_.uses_offset);
  }

  /// Fits the input to the statement, and keeps it where it is the nearest or smallest so far.
  guarantees::Excess judged(Case& input) {
    statement_.fit(input);
    if (!statement_.uses_t_next) input.t_next = 0;
    if (!statement_.uses_offset) input.offset = 0;
    const auto excess = statement_.excess(method_, input);
    if (!excess) return excess;
    if (!found_.nearest || *excess > found_.nearest->measure) found_.nearest = RecordedCase::of(input, *excess);
    if (*excess > 0) keep_if_smaller(input);
    return excess;
  }

  bool keep_if_smaller(const Case& input) {
    const auto size = this->size(input);
    if (smallest_ && !(size < size_ || (size == size_ && input < *smallest_))) return false;
    smallest_ = input;
    size_ = size;
    return true;
  }

  std::int64_t climb(guarantees::Draws<Scalar>& draws, std::int64_t budget) {
    std::int64_t steps = 0;
    Case at = input_;
    constexpr double none = -std::numeric_limits<double>::infinity();
    double height = none;  // of an input that the statement is about
    for (; steps < budget && !smallest_ && !run::interrupted(); ++steps) {
      Case next = at;
      if (steps % restart == 0) {
        draws.special(next, axes_);
        height = none;
      } else {
        draws.step(next, axes_);
      }
      const auto excess = judged(next);
      if (height == none || (excess && *excess >= height)) {
        at = next;
        height = excess.value_or(none);
      }
    }
    return steps;
  }

  std::int64_t make_smaller() {
    std::int64_t tries = 0;
    Case from = *smallest_;
    guarantees::shrink(from, max_tries, [&](Case candidate, Case& current) {
      ++tries;
      statement_.fit(candidate);
      const auto before = size(current);
      const auto after = size(candidate);
      if (after > before || (after == before && !(candidate < current))) return false;
      const auto excess = judged(candidate);
      if (!excess || !(*excess > 0)) return false;
      current = candidate;
      return true;
    });
    return tries;
  }

  const guarantees::Statement<Scalar>& statement_;
  guarantees::Evaluation<Scalar> method_;
  int axes_;
  Case input_;
  std::optional<Case> smallest_;
  std::int64_t size_ = 0;
  Refutation found_;
};

}  // namespace bezierbench::studies
