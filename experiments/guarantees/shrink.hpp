// SPDX-License-Identifier: MIT
// Makes an input that breaks a property smaller: fewer bits, exponents nearer to 0, zeros.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/powers.hpp"
#include "experiments/guarantees/case.hpp"

namespace bezierbench::guarantees {

/// How much it takes to write a number: 4 for each significant bit, the bits of its exponent, 1 for a minus.
inline int size_of(double x) {
  if (x == 0) return 0;
  const auto exponent = static_cast<unsigned>(std::abs(std::ilogb(x)));
  return 4 * significant_bits(x) + static_cast<int>(std::bit_width(exponent)) + (x < 0 ? 1 : 0);
}

/// The sum of the sizes of the numbers of an input. A t_next beside t is free.
template <class Scalar>
std::int64_t size_of(const Case<Scalar>& input, bool uses_t_next, bool uses_offset) {
  std::int64_t size = size_of(static_cast<double>(input.t));
  for (const Scalar value : input.coefficients) size += size_of(static_cast<double>(value));
  if (uses_t_next && input.t_next != std::nextafter(input.t, Scalar(2)))
    size += size_of(static_cast<double>(input.t_next));
  if (uses_offset) size += size_of(static_cast<double>(input.offset));
  return size;
}

/// `value` with so many significant bits, towards 0.
template <class Scalar>
Scalar with_bits(Scalar value, int bits) {
  int exponent = 0;
  const Scalar significand = std::frexp(value, &exponent);
  return std::ldexp(std::trunc(std::ldexp(significand, bits)), exponent - bits);
}

/// Tries what is smaller in place of each number, the smallest first, until nothing helps or `accept` was called
/// `most_tries` times. `accept(candidate, input)` makes a candidate that is smaller and still breaks the property the
/// input, and says whether it did.
template <class Scalar, class Accept>
void shrink(Case<Scalar>& input, int most_tries, const Accept& accept) {
  int tries = 0;
  const auto attempt = [&](const auto& change) {
    if (tries >= most_tries) return false;
    ++tries;
    Case<Scalar> candidate = input;
    change(candidate);
    return accept(candidate, input);
  };
  const auto shrink_number = [&](const auto& number) {
    const auto replace = [&](Scalar by) {
      return attempt([&](Case<Scalar>& candidate) {
        number(candidate) = by;
        candidate.t_next = std::nextafter(candidate.t, Scalar(2));
      });
    };
    const Scalar value = number(input);
    if (value == 0 || replace(0) || replace(1) || replace(-1)) return;
    for (int bits = 1; bits < significant_bits(static_cast<double>(value)); bits += 1 + bits / 8) {
      const Scalar lower = with_bits(value, bits);
      const Scalar upper = lower + std::copysign(std::ldexp(Scalar(1), binary_exponent(value) - bits), value);
      if (replace(lower) || (std::isfinite(upper) && replace(upper))) return;
    }
    replace(-value);
  };
  /// All coordinates and the offset by a power of two, so that the largest is in [1, 2).
  const auto normalise = [&] {
    Scalar largest = 0;
    for (const Scalar value : input.coefficients) largest = std::max(largest, std::abs(value));
    if (largest == 0) return;
    const int by = -std::ilogb(largest);
    attempt([&](Case<Scalar>& candidate) {
      for (Scalar& value : candidate.coefficients) value = std::ldexp(value, by);
      candidate.offset = std::ldexp(candidate.offset, by);
    });
  };
  for (bool smaller = true; smaller && tries < most_tries;) {
    const Case<Scalar> before = input;
    normalise();
    shrink_number([](Case<Scalar>& one) -> Scalar& { return one.t; });
    for (std::size_t k = 0; k < input.coefficients.size(); ++k)
      shrink_number([k](Case<Scalar>& one) -> Scalar& { return one.coefficients[k]; });
    shrink_number([](Case<Scalar>& one) -> Scalar& { return one.offset; });
    smaller = before < input || input < before;
  }
}

}  // namespace bezierbench::guarantees
