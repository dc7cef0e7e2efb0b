// SPDX-License-Identifier: MIT
// A double as what it is: an integer times a power of two.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace bezierbench {

/// significand 2^exponent with |significand| < 2^53, not normalised.
struct SplitDouble {
  std::int64_t significand;
  int exponent;
};

/// A finite value.
inline SplitDouble split_double(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

/// Numbers over one power of two: integers[i] 2^exponent.
template <class Integer>
struct Aligned {
  std::vector<Integer> integers;
  int exponent = 0;
};

/// Finite values; the exponent is the smallest of those that are not 0.
template <class Integer>
Aligned<Integer> aligned(std::span<const double> values) {
  Aligned<Integer> all;
  int lowest = std::numeric_limits<int>::max();
  for (const double value : values)
    if (value != 0) lowest = std::min(lowest, split_double(value).exponent);
  if (lowest != std::numeric_limits<int>::max()) all.exponent = lowest;
  all.integers.reserve(values.size());
  for (const double value : values) {
    const auto [significand, exponent] = split_double(value);
    Integer integer = significand;
    if (value != 0) integer <<= static_cast<unsigned>(exponent - lowest);
    all.integers.push_back(std::move(integer));
  }
  return all;
}

}  // namespace bezierbench
