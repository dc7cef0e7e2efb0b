// SPDX-License-Identifier: MIT
// A hodograph as a series of Chebyshev polynomials of z in [-1, 1], and the bounds of the speed that it
// proves.
//
// The series of a part that is half as wide converges faster, so negligible terms are left out. A panel next to a cusp
// or a turn soon needs a few terms only, whatever the degree is.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include "reference/pair.hpp"

namespace bezierbench::reference {

// A real number as a pair of doubles, with the operators that true lengths are computed with.
//
// In units of u^2 = 2^-106 a product is off by at most 8 of itself, a quotient by 16, a square root by 6, and a sum by
// 4 of the sum of the sizes of its terms (pair.hpp). Numbers must stay away from overflow, and sums of interest from
// 2^-900.

class PairReal {
 public:
  PairReal() = default;
  template <std::floating_point Number>
  PairReal(Number value) : pair_{value, 0} {}  // NOLINT(google-explicit-constructor): as the numbers of Boost
  /// Of at most 53 bits.
  template <std::integral Number>
  PairReal(Number value) : pair_{static_cast<double>(value), 0} {}  // NOLINT(google-explicit-constructor)
  explicit PairReal(Pair pair) : pair_(pair) {}

  [[nodiscard]] const Pair& pair() const { return pair_; }
  /// The double nearest to it.
  template <std::same_as<double> Number>
  [[nodiscard]] Number convert_to() const {
    return pair_.high;
  }

  friend PairReal operator-(const PairReal& x) { return PairReal(Pair{-x.pair_.high, -x.pair_.low}); }
  friend PairReal operator+(const PairReal& x, const PairReal& y) { return PairReal(sum(x.pair_, y.pair_)); }
  friend PairReal operator-(const PairReal& x, const PairReal& y) { return x + -y; }
  friend PairReal operator*(const PairReal& x, const PairReal& y) { return PairReal(product(x.pair_, y.pair_)); }
  friend PairReal operator/(const PairReal& x, const PairReal& y) { return PairReal(quotient(x.pair_, y.pair_)); }
  PairReal& operator+=(const PairReal& y) { return *this = *this + y; }
  PairReal& operator-=(const PairReal& y) { return *this = *this - y; }
  PairReal& operator*=(const PairReal& y) { return *this = *this * y; }

  friend bool operator==(const PairReal& x, const PairReal& y) {
    return x.pair_.high == y.pair_.high && x.pair_.low == y.pair_.low;
  }
  friend std::partial_ordering operator<=>(const PairReal& x, const PairReal& y) {
    return x.pair_.high == y.pair_.high ? x.pair_.low <=> y.pair_.low : x.pair_.high <=> y.pair_.high;
  }

  friend PairReal abs(const PairReal& x) { return x.pair_.high < 0 ? -x : x; }

  friend PairReal sqrt(const PairReal& x) {
    if (x.pair_.high <= 0) return 0;
    const double root = std::sqrt(x.pair_.high);
    const double rest = fused(-root, root, x.pair_.high) + x.pair_.low;
    return PairReal(pair_of(fast_two_sum(root, rest / (2 * root))));
  }

 private:
  Pair pair_;
};

using LongReal = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>>;

/// What the precision of a type of numbers decides. The unit is eight times what a product may be off.
template <class Real>
struct Precision;

template <>
struct Precision<LongReal> {
  static constexpr int points_of_rule = 44;
  static constexpr double negligible = 1e-36;  ///< part of a length that a panel may miss
  static constexpr double straight = 1e-60;    ///< part by which polygon and chord of a straight line differ
  static constexpr double parameter_error =
      1e-40;                                   ///< part of the whole length by which that at a parameter may be off
  static constexpr double work_limit = 1.5e8;  ///< products, some ten seconds; then panels are taken as they are
  static LongReal unit() { return 4 * std::numeric_limits<LongReal>::epsilon(); }
};

template <>
struct Precision<PairReal> {
  static constexpr int points_of_rule = 30;
  static constexpr double negligible = 1e-28;
  static constexpr double straight = 0x1p-90;
  static constexpr double parameter_error = 1e-27;
  static constexpr double work_limit = 2e6;
  static PairReal unit() { return 0x1p-100; }
};

/// Control vectors of a hodograph in Bernstein form, point by point.
template <class Real>
struct Hodograph {
  std::size_t dimension;
  std::vector<Real> vectors;
  Real off = 0;  ///< by which roundings may have changed the mean speed; in a rational curve, any of the vectors
  /// Of a rational curve, W; empty, or one element of dimension 1. The speed is then |h| / W^2.
  std::vector<Hodograph> weight = {};

  [[nodiscard]] std::size_t degree() const { return vectors.size() / dimension - 1; }

  /// Halves or cuts: the part on [0, t] stays here, that on [t, 1] is returned.
  Hodograph split(const Real& t);

  /// Mean size of the vectors, and the size of their mean: polygon and chord, for a parameter of width 1.
  [[nodiscard]] Real polygon() const;
  [[nodiscard]] Real chord() const;
};

using LongHodograph = Hodograph<LongReal>;

/// h = sum a_k T_k(z), k = 0 .. degree. For a rational curve the speed is |h| / W^2, with a series for W as well; the
/// degree and the dimension are those of h.
template <class Real>
class SpeedSeries {
 public:
  /// What is uncertain of |h| and of W.
  struct Off {
    Real vectors = 0;
    Real weight = 0;
  };

  /// Interpolates h, over [0, 1], at the roots of T_(m+1), which is exact except for rounding.
  explicit SpeedSeries(const Hodograph<Real>& h);

  [[nodiscard]] std::size_t degree() const { return coefficients_.size() / dimension_ - 1; }
  [[nodiscard]] std::size_t dimension() const { return dimension_; }

  /// The speed at z by Clenshaw's algorithm.
  [[nodiscard]] Real speed(const Real& z) const;

  /// The mean speed on [-1, z_end], z_end > -1: the chord where the curve stays ahead, else by the Gauss-Legendre rule
  /// of Precision.
  [[nodiscard]] Real mean_speed_to(const Real& z_end) const;

  /// An upper bound of the speed on [-1, 1]; infinite where W is not known to have no root.
  [[nodiscard]] Real largest() const;

  /// |mean of h| on [-1, z_end], z_end > -1, over the largest W^2, which the mean speed there is never below.
  [[nodiscard]] Real chord_to(const Real& z_end) const;

  /// What |h| and W at z lose by rounding, in units of Precision, for z that is right to a unit.
  [[nodiscard]] Off rounding_of_values() const;
  /// How much roundings of halve() may change h and W, in the unit of Precision.
  [[nodiscard]] Off rounding_of_halving() const;

  /// How much these change the speed; infinite where W is not known to have no root.
  [[nodiscard]] Real change_of_speed(const Off& off) const;

  /// True where h has one axis and no root, because a_0 is larger than all other terms together.
  [[nodiscard]] bool stays_ahead() const;

  /// A proved bound of the error of mean_speed_to(1), valid for shorter parts of [-1, 1] as well; negative where none
  /// of at most `allowed` is proved.
  [[nodiscard]] Real proved_miss(const Real& allowed) const;

  /// Removes as many of the last terms as change the speed by at most `allowed`; returns a bound of the change of |h|
  /// and W.
  Off shorten(const Real& allowed);

  /// The coefficients by which T_k on a whole interval is a sum of T_j on one half, for series up to this degree.
  class Halving;

  /// The half on [-1, 0] stays here, that on [0, 1] is returned; both have z in [-1, 1] again.
  SpeedSeries halve(const Halving& halving);

 private:
  explicit SpeedSeries(std::size_t dimension) : dimension_(dimension) {}
  [[nodiscard]] Real size_1(std::size_t k) const;  ///< of a_k, the sum over the axes, which is at least |a_k|
  [[nodiscard]] Real size_of_first() const;        ///< |a_0|
  [[nodiscard]] Real size_of_values() const;       ///< of |h| on [-1, 1], an upper bound
  /// A lower bound of |W| on [-1, 1]; 0 or less where none is known.
  [[nodiscard]] Real least_weight() const;
  Real shorten_vectors(const Real& allowed);

  std::size_t dimension_;
  std::vector<Real> coefficients_;   ///< point by point
  std::vector<SpeedSeries> weight_;  ///< of a rational curve
};

template <class Real>
class SpeedSeries<Real>::Halving {
 public:
  explicit Halving(std::size_t degree);
  /// The coefficient of T_j(y) in T_k((y + 1)/2), j <= k. In T_k((y - 1)/2) it has the sign of (-1)^(j+k).
  [[nodiscard]] const Real& operator()(std::size_t j, std::size_t k) const { return rows_[k * (k + 1) / 2 + j]; }

 private:
  std::vector<Real> rows_;
};

}  // namespace bezierbench::reference
