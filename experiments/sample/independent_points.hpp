// SPDX-License-Identifier: MIT
// Generators that draw every control point by itself. Those of rational curves are in weights.hpp.
#pragma once

#include <cmath>
#include <cstdint>

#include "experiments/sample/generator.hpp"
#include "experiments/sample/words.hpp"

namespace bezierbench::sample {

/// Takes two words for t and two per coordinate, the high one first.
struct Continuous {
  static constexpr GeneratorInfo info{"continuous", "uniform in [-R, R] from 128 random bits, rounded once",
                                      "uniform in [t_min, t_max] from 128 random bits, rounded once"};

  static double coordinate(Words& words, double range) { return affine(-range, range, words.next_uniform()); }
  static double parameter(Words& words, suite::Interval t) { return affine(t.min, t.max, words.next_uniform()); }
};

/// `dyadic`: as `continuous`, with a t for which 1 - t is exact.
/// Takes the words that `continuous` takes. Where t_min or t_max is not a multiple of 2^-53, t may leave the interval
/// by 2^-54.
struct Dyadic {
  static constexpr GeneratorInfo info{"dyadic", "as continuous",
                                      "as continuous, then rounded to a multiple of 2^-53, so that 1 - t is exact"};

  static double coordinate(Words& words, double range) { return Continuous::coordinate(words, range); }

  static double parameter(Words& words, suite::Interval interval) {
    const double t = Continuous::parameter(words, interval);
    if (std::abs(t) >= 0.5) return t;                   // already a multiple; the product below could overflow
    return std::nearbyint(t * 0x1p53) * 0x1p-53 + 0.0;  // ties to even; + 0.0 makes -0 a 0
  }
};

/// `integer`: integer coordinates, whose sums and small products are exact.
/// Takes two words per coordinate: a number below 2m + 1, minus m, with m = floor(R).
struct Integer {
  static constexpr GeneratorInfo info{.id = "integer",
                                      .coordinates = "integers, uniform in [-R, R]; 1 <= R <= 2^53",
                                      .t = "as continuous",
                                      .limits = {.smallest_range = 1, .largest_range = 0x1p53}};

  static double coordinate(Words& words, double range) {
    const auto m = static_cast<std::int64_t>(range);
    const std::uint64_t index = words.next_below(static_cast<std::uint64_t>(2 * m + 1));
    return static_cast<double>(static_cast<std::int64_t>(index) - m);
  }

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

/// `report`: the inputs of the source report, a lattice of 20001 coordinates and 32768 parameters.
/// Takes one word per value. Its leading 15 bits are r, a result of the C library's rand() in the source report. The
/// expressions are those of the source report, in its order of operations, each operation rounded to double.
struct Report {
  static constexpr GeneratorInfo info{.id = "report",
                                      .coordinates = "R * ((r % 20001 - 10000) / 10000.0), r of 15 bits",
                                      .t = "t_min + (t_max - t_min) * (r / 32767.0), r of 15 bits",
                                      .limits = {.finite_width = true}};

  static double coordinate(Words& words, double range) {
    const int r = fifteen_bits(words);
    return range * ((r % 20001 - 10000) / 10000.0);
  }

  static double parameter(Words& words, suite::Interval t) {
    const int r = fifteen_bits(words);
    return t.min + (t.max - t.min) * (r / 32767.0);
  }

 private:
  static int fifteen_bits(Words& words) { return static_cast<int>(words.next() >> 49U); }
};

/// `distant`: small curves far from the origin, such as a road in a country's coordinates. Differences of
/// control points lose twenty bits.
/// Takes the words that `continuous` takes.
struct Distant {
  static constexpr GeneratorInfo info{
      "distant",
      "uniform in [R (1 - 2^-20), R] from 128 random bits, rounded once; the lower end, "
      "too, is rounded",
      "as continuous"};

  static double coordinate(Words& words, double range) {
    return affine(range * (1 - 0x1p-20), range, words.next_uniform());
  }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

/// `local`: curves of size about 1 whose distance from the origin is R, as outlines on a page are. With a larger R more
/// digits of every coordinate are those of the place, not of the shape.
/// Takes the words that `continuous` takes.
struct Local {
  static constexpr GeneratorInfo info{
      .id = "local",
      .coordinates =
          "uniform in [R - 1, R] from 128 random bits, rounded once; R, from 1 on, is the distance over the size",
      .t = "as continuous",
      .limits = {.smallest_range = 1, .largest_range = 0x1p52}};

  static double coordinate(Words& words, double range) { return affine(range - 1, range, words.next_uniform()); }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

/// `graded`: coordinates from sixty binades in one curve, so that sums with large ones lose the small ones.
/// Takes four words per coordinate, two for the exponent before the two that `continuous` takes.
struct Graded {
  static constexpr GeneratorInfo info{
      .id = "graded", .coordinates = "2^-e c; e an integer, uniform in [0, 60]; c as continuous", .t = "as continuous"};

  static double coordinate(Words& words, double range) {
    constexpr std::uint64_t exponents = 61;
    const auto exponent = static_cast<int>(words.next_below(exponents));
    return std::ldexp(Continuous::coordinate(words, range), -exponent);  // a subnormal result is rounded once more
  }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

}  // namespace bezierbench::sample
