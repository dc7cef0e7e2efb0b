// SPDX-License-Identifier: MIT
// The step of a search from one input to a neighbouring one. Rounding errors are not smooth in the inputs, so no
// gradient helps: a step changes a few bits, signs or magnitudes, and is kept unless it makes the error smaller (a
// (1+1) evolution strategy; Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., chapter 26, searches for
// bad inputs likewise).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "experiments/sample/cell.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/sample/words.hpp"

namespace bezierbench::studies {

/// Random neighbours within the box of a cell: coordinates in [-R, R], t in its interval, weights in the binades of the
/// weights that were drawn. The result depends on the given input and the random words only.
class Climb {
 public:
  /// Bits of a double below `lowest_bit` are not changed: 29 for methods in float, which would round them away.
  Climb(const sample::Cell& cell, int lowest_bit) : cell_(cell), lowest_bit_(lowest_bit) {}

  /// Makes one to three changes.
  void step(sample::Words& words, sample::Trial& trial) const {
    for (auto changes = 1 + below(words, 3); changes > 0; --changes) change(words, trial);
  }

 private:
  static std::uint64_t below(sample::Words& words, std::uint64_t count) { return words.next() % count; }

  void change(sample::Words& words, sample::Trial& trial) const {
    constexpr std::uint64_t one_in_parameter = 2;
    constexpr std::uint64_t one_in_weight = 3;
    if (below(words, one_in_parameter) == 0)
      trial.t = changed_parameter(words, trial.t);
    else if (!trial.weights.empty() && below(words, one_in_weight) == 0)
      change_weight(words, trial.weights);
    else
      change_coordinate(words, trial);
  }

  [[nodiscard]] double changed_parameter(sample::Words& words, double t) const {
    const auto [low, high] = cell_.t_interval;
    switch (below(words, 8)) {
      case 0: return low;
      case 1: return high;
      case 2: return low + (high - low) * fraction(words);
      default: {
        const double next = with_other_bits(words, t);
        return next >= low && next <= high ? next : t;
      }
    }
  }

  void change_coordinate(sample::Words& words, sample::Trial& trial) const {
    const double range = cell_.coordinate_range;
    double& value = trial.coefficients[below(words, trial.coefficients.size())];
    const double old = value;
    switch (below(words, 8)) {
      case 0: value = range * (2 * fraction(words) - 1); break;
      case 1: value = -value; break;
      case 2: value = std::copysign(range, value); break;
      case 3: value = std::ldexp(value, static_cast<int>(below(words, 121)) - 60); break;
      case 4: value = trial.coefficients[below(words, trial.coefficients.size())]; break;
      default: value = with_other_bits(words, value);
    }
    if (!(std::abs(value) <= range)) value = old;
  }

  void change_weight(sample::Words& words, std::vector<double>& weights) const {
    double& weight = weights[below(words, weights.size())];
    if (below(words, 2) == 0)
      weight = weights[below(words, weights.size())];
    else
      weight = with_other_bits(words, weight);
  }

  /// In [0, 1).
  static double fraction(sample::Words& words) { return static_cast<double>(words.next() >> 11U) * 0x1p-53; }

  /// The same binade, with random bits below a random one.
  [[nodiscard]] double with_other_bits(sample::Words& words, double value) const {
    const auto count = static_cast<std::uint64_t>(52 - lowest_bit_);
    const std::uint64_t mask = ((2ULL << below(words, count)) - 1) << static_cast<unsigned>(lowest_bit_);
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ (words.next() & mask));
  }

  sample::Cell cell_;
  int lowest_bit_;
};

}  // namespace bezierbench::studies
