// SPDX-License-Identifier: MIT
// The concept of a generator: which doubles are drawn, and how from random words.
#pragma once

#include <concepts>
#include <string_view>

#include "experiments/sample/words.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::sample {

/// The part of a generator that is data, for `list generators`.
struct GeneratorInfo {
  std::string_view id;           ///< as in suites
  std::string_view coordinates;  ///< what coordinates are
  std::string_view t;            ///< what parameters are
};

/// A generator draws a coordinate in [-R, R] (finite R >= 0) and a parameter in [t.min, t.max] from the words of a
/// trial. How many words it takes may depend on nothing but the generator, so that draws keep their places.
template <class G>
concept Generator = requires(Words& words, double range, suite::Interval t) {
  { G::info } -> std::convertible_to<GeneratorInfo>;
  { G::coordinate(words, range) } -> std::same_as<double>;
  { G::parameter(words, t) } -> std::same_as<double>;
};

}  // namespace bezierbench::sample
