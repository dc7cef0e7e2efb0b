// SPDX-License-Identifier: MIT
// Many points at once in double-double arithmetic, each with a proved bound on its error. This is the fast reference.
//
// Bernstein form, n <= 56 so that C(n,i) is a double: for t <= 1/2 let L = 1-t and r = t/L, and c_i = C(n,i) b_i (a
// pair without error); then p = L^n (c_0 + r (c_1 + ...)). For t > 1/2 the same holds from the other end.
// Power form: Horner's scheme.
//
// Error, in units of u^2 = 2^-106 and to first order ([Joldes et al. 2017] bound such operations more tightly): a
// product of pairs drops low low (1) and rounds low high (1), the fused sum (2) and the last sum (3): at most 8 |x y|.
// A sum of pairs rounds the sum of the low parts (1) and the last sum (2): at most 4 (|x| + |y|). A quotient of pairs:
// at most 24. So a term passes n products, n sums, n factors r, and with L^n n products more: 8n + 4n + 24n + 8n + 8;
// in power form 8n + 4n. These factors multiply P, the sum of the |terms| of the coordinate, so the error of a
// coordinate is at most error_factor(n) u^2 P. P itself is summed beside it in double. All its terms are positive, so
// its relative error is at most 10 (n + 1) u; a relative margin of 2^-40 covers it.
//
// Underflow: with |t| <= 8 every partial sum loses at most 2^-1070 per operation, which L^n and the later steps raise
// by less than 2^384. A point is certified only for 2^-600 <= P, so that one unit of the factor, 2^-706, covers it.
// Overflow: coefficients are at most 2^600 there.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

/// On each axis high + low, the nearest double and the remainder, with an error of at most `error`.
struct CertifiedPoint {
  int dimension = 0;
  std::array<double, max_dimension> high{};
  std::array<double, max_dimension> low{};
  double error = 0;

  /// The Euclidean distance of a finite point, rounded once to 24 significant bits; empty where that is not proved.
  [[nodiscard]] std::optional<double> distance(std::span<const double> point) const;
};

inline constexpr std::size_t certified_lanes = 16;
using CertifiedLanes = std::array<double, certified_lanes>;

/// Coordinates of points side by side, by axis; unused axes are 0.
using PointLanes = std::array<CertifiedLanes, max_dimension>;

/// Many CertifiedPoints side by side; `error` is NaN for a point that is not certified.
struct CertifiedBlock {
  PointLanes high{};
  PointLanes low{};
  CertifiedLanes error{};

  /// The distances, as CertifiedPoint::distance; NaN where none is proved.
  [[nodiscard]] CertifiedLanes distances(const PointLanes& points) const;
};

/// A block of trials of one form, dimension and degree, a lane for each, so that the processor's vectors are full.
class CertifiedPoints {
 public:
  static constexpr std::size_t lanes = certified_lanes;

  CertifiedPoints(Form form, int dimension, int degree);

  /// False where no values have a proved error; then no other member may be called.
  static bool applies(Form form, int degree);

  /// Trial number `lane` of the block; every lane that is read after `evaluate` must have been loaded.
  void load(std::size_t lane, const CurveView<double>& curve, double t);

  void evaluate();

  /// The points of all lanes.
  [[nodiscard]] const CertifiedBlock& points() const { return points_; }

  /// The point of a lane; empty where the error is not proved.
  [[nodiscard]] std::optional<CertifiedPoint> point(std::size_t lane) const;

 private:
  using Lanes = CertifiedLanes;
  struct Pairs {
    Lanes high{};
    Lanes low{};
  };

  void set_ratio(std::size_t lane, double t);
  void multiply_by_power();
  void finish();

  Form form_;
  int dimension_;
  int degree_;
  std::vector<double> binomials_;    ///< C(n,i); 1 in power form
  std::vector<Lanes> coefficients_;  ///< point by point, in the reverse order of Horner's scheme
  Pairs ratio_;                      ///< the factor of Horner's scheme: r, or t in power form
  Pairs larger_;                     ///< L
  Lanes unknown_{};                  ///< 0 where t and coefficients are in the range of the proof, else NaN
  std::array<Pairs, max_dimension> sums_;
  std::array<Lanes, max_dimension> magnitudes_;  ///< P
  CertifiedBlock points_;
};

}  // namespace bezierbench::reference
