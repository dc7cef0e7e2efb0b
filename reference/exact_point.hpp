// SPDX-License-Identifier: MIT
// A point that is known exactly, and the distance of a computed point from it.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>

#include "reference/rational.hpp"

namespace bezierbench::reference {

inline constexpr int max_dimension = 3;

/// Coordinate a is numerator[a] / denominator 2^exponent; denominator >= 0.
struct ExactPoint {
  int dimension = 0;
  std::array<mpz_class, max_dimension> numerator;
  mpz_class denominator = 1;
  long exponent = 0;

  /// False for a rational curve where its weights sum to zero: there is no such point.
  [[nodiscard]] bool exists() const { return denominator != 0; }
  [[nodiscard]] Rational coordinate(int axis) const {
    return {numerator[static_cast<std::size_t>(axis)], denominator, exponent};
  }
};

/// The coordinates of `point` (finite doubles), exactly.
ExactPoint exactly(std::span<const double> point);

/// The Euclidean distance of two points of one dimension, rounded once to `error_format`.
double distance(const ExactPoint& a, const ExactPoint& b);

/// The result of `ulp_of_length` where `length` alone decides it. Next to a power of two it does not, because the
/// length may have been rounded up to it.
std::optional<double> ulp_at_length(double length, const Format& format);

/// The spacing of the numbers of `format` at |point|: 2^(e - precision + 1) with 2^e <= |point| < 2^(e+1), at least the
/// smallest subnormal. `length` is |point| rounded to 24 bits; next to powers of two the integers decide.
double ulp_of_length(const ExactPoint& point, double length, const Format& format);

/// Distances from one exact point. Holds a high-order floating-point expansion of the exact coordinates, good enough
/// for almost every distance; where rounding to 24 bits would not be certain from it, the integers decide.
class Distance {
 public:
  /// Keeps a reference to `exact`, which must outlive it unchanged.
  explicit Distance(const ExactPoint& exact);
  /// From a point with finite double coordinates, which must outlive it unchanged.
  explicit Distance(std::span<const double> point);

  /// The Euclidean distance of `point`, rounded once to 24 significant bits (and, below 2^-1051,
  /// to a multiple of 2^-1074). Infinite where it overflows or a coordinate is not finite.
  [[nodiscard]] double to(std::span<const double> point) const;

  /// The distance from the origin, rounded likewise.
  [[nodiscard]] double to_origin(int dimension) const {
    return to(std::span(origin).first(static_cast<std::size_t>(dimension)));
  }

 private:
  static constexpr std::array<double, max_dimension> origin{};

  /// A coordinate as (high + middle + low) 2^exponent with |high| in [1/2, 1], each part at most half an ulp of the one
  /// before, and a remainder below 2^-155 (zero, if `complete`).
  struct Expansion {
    double high = 0;
    double middle = 0;
    double low = 0;
    long exponent = 0;
    bool complete = true;
  };
  struct Difference {
    double value = 0;  ///< times 2^exponent
    long exponent = 0;
    bool certain = true;  ///< relative error below 2^-48
  };

  static Expansion expand(const mpz_class& numerator, const mpz_class& denominator, long exponent);
  static Difference difference(double value, const Expansion& expansion);
  [[nodiscard]] double exact_distance(std::span<const double> point) const;

  const ExactPoint* exact_ = nullptr;  ///< null where the point is `point_`
  std::span<const double> point_;
  std::array<Expansion, max_dimension> expansions_;
};

}  // namespace bezierbench::reference
