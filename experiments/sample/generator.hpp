// SPDX-License-Identifier: MIT
// The concept of a generator: a rule that turns random words into doubles.
#pragma once

#include <concepts>
#include <span>
#include <string_view>

#include "experiments/sample/words.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::sample {

/// The description of a generator, for `list generators` and for the check of suites.
struct GeneratorInfo {
  std::string_view id;            ///< as in suites
  std::string_view coordinates;   ///< what coordinates are
  std::string_view t;             ///< what parameters are
  std::string_view weights = {};  ///< what weights are; empty where none are drawn
  suite::GeneratorLimits limits = {};
};

/// Draws a parameter in [t.min, t.max] from the first words of a trial. The number of words that a draw takes may
/// depend only on the generator and the degree, so that the place of every later draw is known.
template <class G>
concept ParameterGenerator = requires(Words& words, suite::Interval t) {
  { G::info } -> std::convertible_to<GeneratorInfo>;
  { G::parameter(words, t) } -> std::same_as<double>;
};

/// Draws coordinates one by one, each in [-R, R] (finite R >= 0).
template <class G>
concept CoordinateGenerator = ParameterGenerator<G> && requires(Words& words, double range) {
  { G::coordinate(words, range) } -> std::same_as<double>;
};

/// Also draws weights, one by one, each positive.
template <class G>
concept WeightGenerator = CoordinateGenerator<G> && requires(Words& words) {
  { G::weight(words) } -> std::same_as<double>;
};

/// Draws the coefficients of a whole polynomial of degree coefficients.size() - 1 for R = 1, ascending, in the form of
/// the curve. The coefficients are exact, also after multiplication by an R that the limits allow. Every axis of a
/// curve has the same ones.
template <class G>
concept PolynomialGenerator = ParameterGenerator<G> &&
    requires(Words& words, Form curve, std::span<double> coefficients) {
  { G::polynomial(words, curve, coefficients) } -> std::same_as<void>;
};

/// Draws the coordinates of a whole curve in Bernstein form, point by point, for R = 1. The coordinates are exact, also
/// after multiplication by an R that the limits allow.
template <class G>
concept CurveGenerator = ParameterGenerator<G> && requires(Words& words, int dimension, std::span<double> coordinates) {
  { G::curve(words, dimension, coordinates) } -> std::same_as<void>;
};

/// Draws the coordinates of a whole curve in Bernstein form, point by point, each in [-R, R] (finite R >= 0) and
/// rounded.
template <class G>
concept RoundedCurveGenerator = ParameterGenerator<G> &&
    requires(Words& words, int dimension, double range, std::span<double> coordinates) {
  { G::rounded_curve(words, dimension, range, coordinates) } -> std::same_as<void>;
};

template <class G>
concept Generator = CoordinateGenerator<G> || PolynomialGenerator<G> || CurveGenerator<G> || RoundedCurveGenerator<G>;

}  // namespace bezierbench::sample
