// SPDX-License-Identifier: MIT
// Formula: halves the curve and drops pieces that cannot hold the nearest point. Of |C - P|^2 in Bernstein form,
//     g_k = sum_(i+j=k) C(n,i) C(n,j) / C(2n,k) (b_i - P).(b_j - P),
//   the least coefficient is a lower bound on the piece, and its ends give upper bounds. The least g_k is never below
//   the squared distance of the convex hull where that is positive; it is close to it and converges quadratically.
// Source: the bound of the document's third answer is wrong: the distance of a control polygon's vertices is not a
//   lower bound. [Chen et al. 2007] clip by the coefficients of |C - P|^2.
// Cost: some 100 pieces.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1). A piece is dropped only where it cannot be nearer
//   than the best parameter by more than its rounding errors: 2c u of the distance, c = d (5n + d + 5), and those of
//   halving, (n + 1) u times the size of every piece that it was cut from; or where it is narrower than 2^-54. The best
//   parameter is then polished.
//   Of rational curves, C - P = V / W (rational_offset.hpp), a piece is dropped where no coefficient of
//   |V|^2 - D^2 W^2 is negative, D the least distance less a margin (docs/proofs/rational_projection.md).
// Fails: beyond degree 512 the binomials of degree 2n overflow. Next to a curve whose distance is constant up to
//   rounding over a long part it ends after 20,000 pieces, and `converged` is false. It is false, too, where a
//   rational curve runs between neighbouring doubles t, as it does past weights that differ by many powers of two, and
//   next to a pole, where distances lose more than 23 bits.
#pragma once

#include <vector>

#include "core/binomial.hpp"
#include "core/project/kernel.hpp"
#include "core/project/rational_offset.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

struct SubdivideHull {
  static constexpr MethodInfo info{.id = "subdivide_hull",
                                   .label = "Subdivision with a lower bound",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 512,
                                   .promise = "no point of the curve is nearer, to rounding",
                                   .flops = "O(d n^2) per piece",
                                   .cost_exponent = 2,
                                   .citation = "[Chen et al. 2007]; [Document 004]"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <Form F, int Dimension>
  static FootPoint project(const Curve<F, double, Dimension>& curve, const Point<double, Dimension>& point) {
    const auto offset = offset_of(curve, point);
    constexpr int axes = F == Form::rational ? Dimension + 1 : Dimension;
    const Binomials binomials(offset.degree());
    Best best{0, std::numeric_limits<double>::infinity()};
    best.take(0, offset.scaled_distance(0));
    best.take(1, offset.scaled_distance(1));
    std::vector<Piece<axes>> level{{offset.offsets(), 0, 0}};
    int judged = 0;
    bool is_known = true;  // the distance of the nearest point, from that at a double t
    for (double width = 1; !level.empty() && width >= smallest_width && judged < max_pieces; width /= 2) {
      std::vector<Piece<axes>> next;
      for (auto& piece : level) {
        ++judged;
        if (!may_be_nearer(offset, piece, binomials, best.distance)) continue;
        const double middle = piece.from + width / 2;
        best.take(middle, offset.scaled_distance(middle));
        if constexpr (F == Form::rational) {
          const double below = best.distance * (1 - 0x1p-40) - 0x1p-48 * offset.largest_offset();
          if (width == smallest_width && below > 0 && may_be_nearer(offset, piece, binomials, below)) is_known = false;
        }
        const double error = piece.error + 0x1p-53 * static_cast<double>(piece.offset.cols()) *
                                               (F == Form::rational ? 1 : largest_coordinate<axes>(piece.offset));
        Polygon<axes> left;
        Polygon<axes> right;
        halve<axes>(piece.offset, left, right);
        normalise(offset, left);
        normalise(offset, right);
        next.push_back({std::move(left), piece.from, error});
        next.push_back({std::move(right), middle, error});
      }
      level = std::move(next);
    }
    best.t = polished(offset, best.t);
    if constexpr (F == Form::rational)
      is_known = is_known && 0x1p-53 * offset.degree() * offset.cancellation(best.t) <= 0x1p-30;
    return {best.t, offset.distance(best.t), judged, judged < max_pieces && is_known};
  }

 private:
  static constexpr int max_pieces = 20'000;
  static constexpr double smallest_width = 0x1p-54;

  struct Best {
    double t;
    double distance;
    void take(double other, double its_distance) {
      if (!(its_distance < distance)) return;
      t = other;
      distance = its_distance;
    }
  };

  template <int Dimension>
  struct Piece {
    Polygon<Dimension> offset;  ///< control points of C - P, over m as in OffsetCurve
    double from;
    double error;  ///< bound of the error that halving causes in a coordinate; of a rational curve, k u
  };

  struct Binomials {
    using Row = PerCoefficient<double, dynamic>;
    explicit Binomials(int n) : curve(binomials<double, dynamic>(n)), square(binomials<double, dynamic>(2 * n)) {}
    Row curve;
    Row square;
  };

  /// Multiplies V and W by a power of two, which does not change the curve, so that their products do not underflow
  /// where all weights of a piece are small. Weights of two signs stay, since the error of a piece is absolute then.
  template <int Dimension>
  static void normalise(const OffsetCurve<Dimension>& /*offset*/, Polygon<Dimension>& /*piece*/) {}
  template <int Dimension>
  static void normalise(const RationalOffset<Dimension>& offset, Polygon<Dimension + 1>& piece) {
    constexpr double small = 0x1p-100;
    const double largest = largest_coordinate<Dimension + 1>(piece);
    if (!offset.is_positive() || largest >= small || largest == 0) return;
    const int exponent = binary_exponent(largest);
    for (int i = 0; i <= degree_of<Dimension + 1>(piece); ++i)
      for (int axis = 0; axis <= Dimension; ++axis) piece(axis, i) = times_power_of_two(piece(axis, i), -exponent);
  }

  /// Whether a point of the piece may be nearer than `best`; false where every point is at least as far away, up to
  /// rounding.
  template <int Dimension>
  static bool may_be_nearer(const OffsetCurve<Dimension>& /*offset*/, const Piece<Dimension>& piece,
                            const Binomials& binomials, double best) {
    const int n = degree_of<Dimension>(piece.offset);
    const double largest = largest_coordinate<Dimension>(piece.offset);
    const double roundings =
        0x1p-53 * Dimension * (5.0 * n + Dimension + 5);  // error bound of a g_k over the largest product
    const double nearer = std::max(0.0, best * (1 - 2 * roundings) - Dimension * piece.error);
    for (int k = 0; k <= 2 * n; ++k) {
      double sum = 0;
      for (int i = std::max(0, k - n); i <= std::min(k, n); ++i)
        sum +=
            binomials.curve[i] * binomials.curve[k - i] * dot<Dimension>(piece.offset.col(i), piece.offset.col(k - i));
      if (sum / binomials.square[k] - roundings * largest * largest < nearer * nearer) return true;
    }
    return false;
  }

  template <int Dimension>
  static bool may_be_nearer(const RationalOffset<Dimension>& offset, const Piece<Dimension + 1>& piece,
                            const Binomials& binomials, double best) {
    const int n = degree_of<Dimension + 1>(piece.offset);
    constexpr double underflow = 0x1p-1000;  // of the products of a term, over the relative error of a sum
    double least = offset.is_positive() ? 1 : std::abs(piece.offset(Dimension, 0));
    for (int i = 0; i <= n && !offset.is_positive(); ++i) least = std::min(least, piece.offset(Dimension, i));
    const double roundings = 0x1p-53 * (Dimension + 1) * (5.0 * n + Dimension + 9);  // of a sum, over its magnitudes
    const double moved = 2 * Dimension * (piece.error + 0x1p-51) / least;
    if (!(least > 0 && moved <= 0x1p-20)) return true;  // next to a pole nothing is known of the piece
    const double nearer = std::max(0.0, best * (1 - 4 * roundings - moved) - moved * offset.largest_offset());
    for (int k = 0; k <= 2 * n; ++k) {
      double sum = 0;
      double magnitudes = 0;
      for (int i = std::max(0, k - n); i <= std::min(k, n); ++i) {
        const double binomial = binomials.curve[i] * binomials.curve[k - i];
        for (int axis = 0; axis <= Dimension; ++axis) {
          const double factor = axis == Dimension ? -nearer * nearer : 1;
          const double product = factor * (piece.offset(axis, i) * piece.offset(axis, k - i));
          sum += binomial * product;
          magnitudes += binomial * (std::abs(product) + underflow);
        }
      }
      if (sum < roundings * magnitudes) return true;
    }
    return false;
  }
};

}  // namespace bezierbench
