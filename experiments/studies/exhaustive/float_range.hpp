// SPDX-License-Identifier: MIT
// All floats of an interval in [0, 1], in ascending order.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

/// Floats that are not negative are in the order of their bits.
inline float float_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }

/// The floats from `first` to `last`, by their bits.
struct FloatRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;

  [[nodiscard]] std::uint64_t count() const { return std::uint64_t{last} - first + 1; }
};

/// The floats of the interval, 0 <= min <= max <= 1; empty where there is none.
inline std::optional<FloatRange> floats_in(const suite::Interval& interval) {
  const auto bits = [](double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x + 0.0)); };
  std::uint32_t first = bits(interval.min);
  std::uint32_t last = bits(interval.max);
  if (double{float_of(first)} < interval.min) ++first;
  if (double{float_of(last)} > interval.max) {
    if (last == 0) return std::nullopt;
    --last;
  }
  if (first > last) return std::nullopt;
  return FloatRange{first, last};
}

}  // namespace bezierbench::studies
