// SPDX-License-Identifier: MIT
// One input of which a property can hold or not.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "core/split_double.hpp"

namespace bezierbench::guarantees {

/// A curve in Bernstein form and what else the statements speak of. All numbers are finite.
template <class ScalarT>
struct Case {
  using Scalar = ScalarT;
  int dimension = 1;
  std::vector<Scalar> coefficients;  ///< control points, point by point
  Scalar t = 0;
  Scalar t_next = 0;  ///< the larger parameter of a pair; monotone alone uses it
  Scalar offset = 0;  ///< what moves the first axis of every point; translation alone uses it

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) / dimension - 1; }
  [[nodiscard]] Scalar operator()(int axis, int i) const { return coefficients[index(axis, i)]; }
  [[nodiscard]] Scalar& operator()(int axis, int i) { return coefficients[index(axis, i)]; }

  /// Some order, the same on every machine.
  friend bool operator<(const Case& a, const Case& b) {
    return std::tie(a.t, a.t_next, a.offset, a.coefficients) < std::tie(b.t, b.t_next, b.offset, b.coefficients);
  }

 private:
  [[nodiscard]] std::size_t index(int axis, int i) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension) + static_cast<std::size_t>(axis);
  }
};

// The bits that a number takes.

/// The exponent of the lowest bit that is set, for x != 0.
inline int lowest_bit(double x) {
  const auto [significand, exponent] = split_double(x);
  return exponent + std::countr_zero(static_cast<std::uint64_t>(significand));
}

/// The bits from the highest to the lowest that is set; 0 for 0.
inline int significant_bits(double x) { return x == 0 ? 0 : std::ilogb(x) - lowest_bit(x) + 1; }

}  // namespace bezierbench::guarantees
