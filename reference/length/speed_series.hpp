// SPDX-License-Identifier: MIT
// A hodograph in 70 digits as a series of Chebyshev polynomials of z in [-1, 1], and the bounds of the speed that it
// proves.
//
// The series of a part that is half as wide converges faster, so negligible terms are left out. A panel next to a cusp
// or a turn soon needs a few terms only, whatever the degree is.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <vector>

namespace bezierbench::reference {

using LongReal = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>>;

/// Control vectors of a hodograph in Bernstein form, point by point.
struct LongHodograph {
  std::size_t dimension;
  std::vector<LongReal> vectors;
  LongReal off = 0;  ///< by which roundings may have changed the mean speed

  [[nodiscard]] std::size_t degree() const { return vectors.size() / dimension - 1; }

  /// Halves or cuts: the part on [0, t] stays here, that on [t, 1] is returned.
  LongHodograph split(const LongReal& t);

  /// Mean size of the vectors, and the size of their mean: polygon and chord, for a parameter of width 1.
  [[nodiscard]] LongReal polygon() const;
  [[nodiscard]] LongReal chord() const;
};

/// h = sum a_k T_k(z), k = 0 .. degree.
class SpeedSeries {
 public:
  /// Interpolates h, over [0, 1], at the roots of T_(m+1), which is exact but for rounding.
  explicit SpeedSeries(const LongHodograph& h);

  [[nodiscard]] std::size_t degree() const { return coefficients_.size() / dimension_ - 1; }
  [[nodiscard]] std::size_t dimension() const { return dimension_; }

  /// |h(z)| by Clenshaw's algorithm.
  [[nodiscard]] LongReal speed(const LongReal& z) const;

  /// The mean speed on [-1, z_end], z_end > -1: the chord where the curve stays ahead, else by the Gauss-Legendre rule
  /// with 44 points.
  [[nodiscard]] LongReal mean_speed_to(const LongReal& z_end) const;

  /// An upper bound of |h| on [-1, 1].
  [[nodiscard]] LongReal largest() const;

  /// |mean of h| on [-1, z_end], z_end > -1, which the mean speed there is never below.
  [[nodiscard]] LongReal chord_to(const LongReal& z_end) const;

  /// True where h has one axis and no root, because a_0 is larger than all other terms together.
  [[nodiscard]] bool stays_ahead() const;

  /// A proved bound of the error of mean_speed_to(1), valid for shorter parts of [-1, 1] as well; negative where none
  /// of at most `allowed` is proved.
  [[nodiscard]] LongReal proved_miss(const LongReal& allowed) const;

  /// Removes as many of the last terms as change |h| by at most `allowed`; returns a bound of the change.
  LongReal shorten(const LongReal& allowed);

  /// The coefficients by which T_k on a whole interval is a sum of T_j on one half, for series up to this degree.
  class Halving;

  /// The half on [-1, 0] stays here, that on [0, 1] is returned; both have z in [-1, 1] again.
  SpeedSeries halve(const Halving& halving);

 private:
  explicit SpeedSeries(std::size_t dimension) : dimension_(dimension) {}
  [[nodiscard]] LongReal size_1(std::size_t k) const;  ///< of a_k, the sum over the axes, which is at least |a_k|

  std::size_t dimension_;
  std::vector<LongReal> coefficients_;  ///< point by point
};

class SpeedSeries::Halving {
 public:
  explicit Halving(std::size_t degree);
  /// The coefficient of T_j(y) in T_k((y + 1)/2), j <= k. In T_k((y - 1)/2) it has the sign of (-1)^(j+k).
  [[nodiscard]] const LongReal& operator()(std::size_t j, std::size_t k) const { return rows_[k * (k + 1) / 2 + j]; }

 private:
  std::vector<LongReal> rows_;
};

}  // namespace bezierbench::reference
