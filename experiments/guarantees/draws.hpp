// SPDX-License-Identifier: MIT
// Random inputs: full significands, of which statistics are made, and others at which rounding goes wrong more often,
// from which a search begins. A pure function of the random words.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "core/powers.hpp"
#include "experiments/guarantees/case.hpp"
#include "experiments/sample/independent_points.hpp"
#include "experiments/sample/words.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
class Draws {
 public:
  explicit Draws(sample::Words& words) : words_(words) {}

  /// Coordinates of the first `axes` axes uniform in [-1, 1], the others 0; t uniform in [0, 1] and its neighbour.
  void full(Case<Scalar>& input, int axes) {
    each_coordinate(input, axes, [&] { return uniform(-1, 1); });
    input.t = uniform(0, 1);
    input.t_next = next_up(input.t);
    input.offset = uniform(-1, 1);
  }

  /// One of the families below for the coordinates, and one for t. In a quarter of the inputs all points are the same, in
  /// another one many are.
  void special(Case<Scalar>& input, int axes) {
    const auto family = below(families);
    const Scalar repeated = coordinate(family);
    const auto repeats = below(4);
    each_coordinate(input, axes,
                    [&] { return repeats == 0 || (repeats == 1 && below(2) == 0) ? repeated : coordinate(family); });
    input.t = parameter();
    input.t_next = below(4) > 0 ? next_up(input.t) : parameter();
    input.offset = coordinate(below(2) == 0 ? family : below(families));
  }

  /// A neighbour of an input: one to three numbers are other ones.
  void step(Case<Scalar>& input, int axes) {
    for (auto changes = 1 + below(3); changes > 0; --changes) switch (below(4)) {
        case 0:
          input.t = below(3) == 0 ? parameter() : changed(input.t);
          if (below(4) > 0) input.t_next = next_up(input.t);
          break;
        case 1: input.offset = changed(input.offset); break;
        default: {
          const auto d = static_cast<std::uint64_t>(input.dimension);
          const auto i = static_cast<int>(below(input.coefficients.size() / d));
          Scalar& value = input(static_cast<int>(below(static_cast<std::uint64_t>(axes))), i);
          value = below(4) == 0 ? coordinate(below(families)) : changed(value);
        }
      }
  }

 private:
  using Limits = std::numeric_limits<Scalar>;
  static constexpr std::uint64_t families = 8;

  std::uint64_t below(std::uint64_t count) { return words_.next() % count; }
  int between(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::uint64_t>(last - first) + 1));
  }
  Scalar sign() { return below(2) == 0 ? Scalar(-1) : Scalar(1); }
  Scalar uniform(double low, double high) {
    return static_cast<Scalar>(sample::affine(low, high, words_.next_uniform()));
  }
  static Scalar power(int exponent) { return std::ldexp(Scalar(1), exponent); }
  /// 1 and a few of its next numbers.
  Scalar around_one(int most) { return 1 + static_cast<Scalar>(between(-most, most)) * Limits::epsilon() / 2; }
  static Scalar next_up(Scalar t) { return std::nextafter(t, Scalar(2)); }

  template <class Coordinate>
  void each_coordinate(Case<Scalar>& input, int axes, const Coordinate& coordinate) {
    for (int i = 0; i <= input.degree(); ++i)
      for (int axis = 0; axis < input.dimension; ++axis) input(axis, i) = axis < axes ? coordinate() : Scalar(0);
  }

  Scalar coordinate(std::uint64_t family) {
    switch (family) {
      case 0: return uniform(-1, 1);
      case 1: return uniform(-1, 1) * power(-between(0, Limits::digits));
      case 2:
      case 3: return static_cast<Scalar>(between(-8, 8)) * power(-between(0, 5));
      case 4: return sign() * around_one(4) * power(-between(0, 5));
      case 5: return sign() * Limits::max() * (1 - static_cast<Scalar>(between(0, 3)) * Limits::epsilon() / 2);
      case 6: return static_cast<Scalar>(between(-9, 9)) * Limits::denorm_min();
      default: return uniform(-1, 1) * power(between(Limits::min_exponent - Limits::digits, Limits::max_exponent - 1));
    }
  }

  Scalar parameter() {
    switch (below(6)) {
      case 0: return uniform(0, 1);
      case 1: return power(-between(0, 3)) * (1 - static_cast<Scalar>(between(0, 63)) * Limits::epsilon() / 2);
      case 2: return power(-between(0, 3)) * (1 - uniform(0, 1) * power(-between(0, Limits::digits)));
      case 3: return static_cast<Scalar>(between(0, 64)) * power(-6);
      case 4: return uniform(0, 1) * power(-between(0, Limits::digits - Limits::min_exponent));
      default: return Scalar(0.5) * around_one(8);
    }
  }

  /// The same sign and binade or nearly so, with other low bits; or its negative, half or twice.
  Scalar changed(Scalar value) {
    switch (below(8)) {
      case 0: return -value;
      case 1: return std::abs(value) <= Limits::max() / 2 ? 2 * value : value;
      case 2: return value / 2;
      case 3: return std::nextafter(value, value < 1 ? Scalar(1) : Scalar(-1));
      case 4: return std::nextafter(value, Scalar(0));
      default: {
        const Scalar other = value + value * uniform(-1, 1) * power(-between(1, Limits::digits - 1));
        return std::isfinite(other) ? other : value;
      }
    }
  }

  sample::Words& words_;
};

// Makes an input that breaks a property smaller: fewer bits, exponents nearer to 0, zeros.

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
