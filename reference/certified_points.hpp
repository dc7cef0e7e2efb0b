// SPDX-License-Identifier: MIT
// Many points at once in double-double arithmetic, each with a proved bound on its error. This is the fast reference.
//
// Bernstein form: for t <= 1/2 let L = 1-t and r = t/L, so that |r| <= 1, k = n/2 rounded down, and
// c_i = C(n,i) 2^-k b_i; then p = (2 L^2)^k L^(n-2k) (c_0 + r (c_1 + ...)). For t > 1/2 the same holds from the other
// end. C(n,i) 2^-k lies between 2^-512 and 2^507 for every n <= 1023, and so do powers of 2 L^2 for t in [0, 1].
// Rational curves: N = c_0 + r (c_1 + ...) with c_i = C(n,i) 2^-k w_i b_i, D likewise with c_i = C(n,i) 2^-k w_i, and
// p = N / D: the powers of L cancel.
// Power form: Horner's scheme in t.
//
// docs/proofs/certified_points.md proves the error, error_factor(n) u^2 P for the sum P of the magnitudes of the terms
// of a coordinate, and that of the quotient; it shows which points may be certified in view of underflow and overflow.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/exact_point.hpp"
#include "reference/pair.hpp"

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

  /// False where no error is proved; then do not construct an object.
  static bool applies(Form form) { return form != Form::power_centered; }

  /// True where this object is for such trials.
  [[nodiscard]] bool is_for(Form form, int dimension, int degree) const {
    return form == form_ && dimension == dimension_ && degree == degree_;
  }

  /// Trial number `lane` of the block; every lane that is read after `evaluate` must have been loaded.
  void load(std::size_t lane, const CurveView<double>& curve, double t);

  void evaluate();
  /// Evaluates lane 0 only, at a quarter of the cost of a block; the other lanes then have no points.
  void evaluate_one();

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
  // The steps of `evaluate` for the first `Count` lanes.
  template <std::size_t Count>
  void evaluate_lanes();
  template <std::size_t Count>
  void add(const Lanes& coefficients, const Pairs& factors, Pairs& sums, Lanes& magnitudes) const;
  template <std::size_t Count>
  void sum_up();
  template <std::size_t Count>
  void find_magnitude();
  template <std::size_t Count>
  void multiply_by_power();
  template <std::size_t Count>
  void divide_by_weights();
  template <std::size_t Count>
  void certify();

  Form form_;
  int dimension_;
  int degree_;
  std::vector<Pair> binomials_;            ///< C(n,i) 2^-k; 1 in power form
  std::vector<Lanes> coefficients_;        ///< point by point, in the reverse order of Horner's scheme
  std::vector<Lanes> weights_;             ///< of rational curves, likewise
  Pairs ratio_;                            ///< the factor of Horner's scheme: r, or t in power form
  Pairs larger_;                           ///< L
  Lanes least_{};                          ///< what P must be at least; NaN where t or a coefficient is out of range
  std::array<Pairs, max_dimension> sums_;  ///< N; in the end the point
  std::array<Lanes, max_dimension> magnitudes_;  ///< P of each axis
  Pairs weight_sums_;                            ///< D
  Lanes weight_magnitudes_{};                    ///< Q
  Lanes magnitude_{};                            ///< the error in units of the factor; P of the largest axis at first
  Lanes smallest_{};                             ///< smallest quantity that underflow could spoil
  CertifiedBlock points_;
};

}  // namespace bezierbench::reference
