// SPDX-License-Identifier: MIT
// The true values of a polynomial in Bernstein form at many floats t of [0, 1], as the error of a float is measured:
// the nearest float, the rest that it leaves, and the ulp.
//
// There are three ways, from fast to slow. Each leaves to the next the t at which its proved error does not decide the
// nearest float (ties to even) or the ulp, or exceeds 2^-20 ulp.
//   1. In double: as b_0 + d for t <= 2^-8, else by Horner's scheme in 1-t; docs/proofs/float_values.md has the error.
//   2. In pairs of doubles: certified_points.hpp.
//   3. In integers: exact_curve.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/certified_points.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::reference {

/// At most so many t at once.
inline constexpr std::size_t float_values_at_once = 1024;

/// The true values p at the t of one call, side by side. ulp(p) = 2^(e - 23) with 2^e <= |p| < 2^(e+1), at least the
/// smallest subnormal, 2^-149.
struct FloatValues {
  template <class T>
  using Row = std::array<T, float_values_at_once>;
  alignas(64) Row<float> nearest;    ///< the float nearest to p, ties to even
  alignas(64) Row<float> rest;       ///< (p - nearest) / ulp(p), right to 2^-19
  alignas(64) Row<float> scale;      ///< scale and scale_too are powers of two: 1 / ulp(p) is their product
  alignas(64) Row<float> scale_too;  ///< since 1 / ulp(p) may be larger than every float
};

class FloatValuesOf {
 public:
  static constexpr std::size_t max_control_points = 101;

  /// The control points, all finite. Throws std::invalid_argument for none, and for more than the bounds above allow.
  explicit FloatValuesOf(std::span<const float> control_points);

  /// Fills the first t.size() values, for t in [0, 1] in ascending order. Throws std::invalid_argument for more than
  /// float_values_at_once.
  void find(std::span<const float> t, FloatValues& values);

  /// The number of values so far that the doubles left undecided.
  [[nodiscard]] std::uint64_t left_by_doubles() const { return left_by_doubles_; }

 private:
  using Doubles = std::array<double, float_values_at_once>;

  /// Values at the first `count` t, which are at most 2^-8.
  void near_zero(std::span<const float> t, std::size_t count);
  /// Values at the t from number `first` on.
  void elsewhere(std::span<const float> t, std::size_t first);
  void decide(std::size_t count, FloatValues& values);
  void decide_rest(std::span<const float> t, FloatValues& values);
  void decide_exactly(double t, std::size_t place, FloatValues& values);
  [[nodiscard]] CurveView<double> curve() const {
    return {Form::bernstein, 1, static_cast<int>(control_points_.size()) - 1, control_points_};
  }

  std::vector<double> control_points_;
  std::vector<double> power_;   ///< q_0, ..., q_n, each rounded once
  std::vector<double> scaled_;  ///< C(n,i) b_i
  double power_factor_ = 0;     ///< of the error, as above
  double scaled_factor_ = 0;    ///< likewise
  double min_error_ = 0;        ///< for underflow; 0 where the curve is a constant
  bool exact_head_ = false;     ///< b_0 = 0, and q_1 t is exact
  alignas(64) Doubles base_{};  ///< p = base + difference, within error
  alignas(64) Doubles difference_{};
  alignas(64) Doubles low_{};
  alignas(64) Doubles high_{};
  alignas(64) Doubles magnitude_{};  ///< sum of magnitudes; then 1/ulp
  alignas(64) Doubles error_{};      ///< of the value; then in ulp, rounded, and 1 where the ulp is not known
  alignas(64) std::array<std::int32_t, float_values_at_once> undecided_{};
  FloatValues pair_values_{};
  std::vector<std::size_t> left_;
  CertifiedPoints pairs_;
  ExactCurve exact_;
  std::uint64_t left_by_doubles_ = 0;
};

}  // namespace bezierbench::reference
