// SPDX-License-Identifier: MIT
// Roots of f = (C - P).C' / n in Bernstein form, degree 2n-1, isolated by Descartes' rule on halved pieces of the
// curve:
//   f_k = sum_(i+j=k) C(n,i) C(n-1,j) / C(2n-1,k) (b_i - P).(b_(j+1) - b_j),
// then Newton on (C - P).C' from the control points. The curve and its differences are halved, not f: near the point
// they are small, and so are then the rounding errors of f.
//
// Source: Chen, Zhou, Shu, Su and Paul, "Improved algebraic algorithm on point projection for Bezier curves", IMSCCS
//   2007, 158-163 (roots of this polynomial, isolated, then Newton); Lane and Riesenfeld, BIT 21 (1981) 112-117
//   (isolation by halving in Bernstein form); Farouki and Rajan, CAGD 5 (1988) 1-26 (products in Bernstein form).
// Cost: O(n^2) flops per piece, most often 2 to 10 pieces, and O(n^2) per Newton step.
// Sure: a running bound of every rounding error says which signs of the f_k are certain. A piece is left out only if no
//   choice of the others allows a root; a piece all of whose signs are uncertain, where the distance is flat to
//   rounding, gives one candidate from which the distance is descended.
// Fails: above degree 512 the binomials of degree 2n-1 overflow.
#pragma once

#include <vector>

#include "core/basis/binomial.hpp"
#include "core/project/nearest.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

struct QuinticIsolate {
  static constexpr MethodInfo info{.id = "quintic_isolate",
                                   .label = "Roots isolated in Bernstein form, Newton",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 512,
                                   .flops = "O(d n^2) per piece and per Newton step",
                                   .cost_exponent = 2,
                                   .citation = "Chen et al. 2007; Lane and Riesenfeld 1981"};

  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    const OffsetCurve<Dimension> offset(curve, point);
    const Binomials binomials(offset.degree());
    std::vector<Piece<Dimension>> pieces{whole(offset)};
    std::vector<double> candidates;
    int judged = 0;
    for (; !pieces.empty() && judged < most_pieces; ++judged) {
      const auto piece = std::move(pieces.back());
      pieces.pop_back();
      const auto signs = signs_of(piece, binomials);
      const int most = most_variations(signs);
      const bool unknown = std::all_of(signs.begin(), signs.end(), [](int sign) { return sign == 0; });
      if (most == 0) continue;
      if (unknown || piece.width < smallest_width)
        candidates.push_back(descend(offset, piece.from + piece.width / 2));
      else if (most == 1)
        candidates.push_back(root_of(offset, piece));
      else
        split(piece, pieces);
    }
    for (const auto& piece : pieces) candidates.push_back(descend(offset, piece.from + piece.width / 2));
    auto foot = nearest(offset, std::move(candidates));
    foot.t = nearest_neighbour(offset, foot.t);
    foot.distance = offset.distance(foot.t);
    foot.converged = judged < most_pieces;
    return foot;
  }

 private:
  static constexpr int most_pieces = 20'000;
  static constexpr double smallest_width = 0x1p-60;

  /// Part of the curve, over m as in OffsetCurve.
  template <int Dimension>
  struct Piece {
    Polygon<Dimension> offset;      ///< of C - P
    Polygon<Dimension> difference;  ///< of C' / n, whatever the width
    double from = 0;
    double width = 1;
    double offset_error = 0;  ///< no coordinate of the polygons is off by more
    double difference_error = 0;
  };

  struct Binomials {
    using Row = PerCoefficient<double, dynamic>;
    explicit Binomials(int n)
        : of_curve(binomials<double, dynamic>(n)),
          of_difference(binomials<double, dynamic>(n - 1)),
          of_product(binomials<double, dynamic>(2 * n - 1)) {}
    Row of_curve;
    Row of_difference;
    Row of_product;
  };

  template <int Dimension>
  static Piece<Dimension> whole(const OffsetCurve<Dimension>& curve) {
    const auto& difference = curve.differences_of_points();
    return {curve.offsets(),
            difference,
            0,
            1,
            0x1p-53 * largest_coordinate<Dimension>(curve.offsets()),
            0x1p-53 * largest_coordinate<Dimension>(difference)};
  }

  template <int Dimension>
  static void split(const Piece<Dimension>& piece, std::vector<Piece<Dimension>>& pieces) {
    const double roundings = 0x1p-53 * static_cast<double>(piece.offset.cols());
    const double offset_error = piece.offset_error + roundings * largest_coordinate<Dimension>(piece.offset);
    const double difference_error =
        piece.difference_error + roundings * largest_coordinate<Dimension>(piece.difference);
    auto [left, right] = halves<Dimension>(piece.offset);
    auto [left_difference, right_difference] = halves<Dimension>(piece.difference);
    const double width = piece.width / 2;
    pieces.push_back(
        {std::move(right), std::move(right_difference), piece.from + width, width, offset_error, difference_error});
    pieces.push_back({std::move(left), std::move(left_difference), piece.from, width, offset_error, difference_error});
  }

  /// What all f_k of the piece may be off by: the errors of the polygons, carried through the products; then at most
  /// d + 1 roundings in a product of vectors, 2n + 4 in weighing and summing, and 3n in binomials that are not exact.
  template <int Dimension>
  static double error_of(const Piece<Dimension>& piece) {
    const double offset = largest_coordinate<Dimension>(piece.offset) + piece.offset_error;
    const double difference = largest_coordinate<Dimension>(piece.difference) + piece.difference_error;
    const double roundings = 0x1p-53 * (5.0 * static_cast<double>(piece.offset.cols()) + Dimension + 5);
    const double carried = piece.offset_error * difference + piece.difference_error * offset;
    return Dimension * (1 + 0x1p-20) * (carried + roundings * offset * difference);
  }

  /// The signs of f_k; 0 where rounding may have decided.
  template <int Dimension>
  static std::vector<int> signs_of(const Piece<Dimension>& piece, const Binomials& binomials) {
    const int n = degree_of<Dimension>(piece.offset);
    const double error = error_of(piece);
    std::vector<int> signs;
    for (int k = 0; k <= 2 * n - 1; ++k) {
      double sum = 0;
      for (int i = std::max(0, k - n + 1); i <= std::min(k, n); ++i)
        sum += binomials.of_curve[i] * binomials.of_difference[k - i] *
               dot<Dimension>(piece.offset.col(i), piece.difference.col(k - i));
      const double coefficient = sum / binomials.of_product[k];
      signs.push_back(coefficient > error ? 1 : coefficient < -error ? -1 : 0);
    }
    return signs;
  }

  /// The most sign variations that any choice for the uncertain signs has.
  static int most_variations(const std::vector<int>& signs) {
    const int none = -static_cast<int>(signs.size()) - 1;
    int after_plus = -1;  // so that the first sign is no variation
    int after_minus = -1;
    for (const int sign : signs) {
      const int plus = sign < 0 ? none : std::max(after_plus, after_minus + 1);
      const int minus = sign > 0 ? none : std::max(after_minus, after_plus + 1);
      after_plus = plus;
      after_minus = minus;
    }
    return std::max(after_plus, after_minus);
  }

  /// The one root in a piece that has at most one. Where the signs at its ends agree the root, if there is any, lies at
  /// an end, as near as rounding tells.
  template <int Dimension>
  static double root_of(const OffsetCurve<Dimension>& curve, const Piece<Dimension>& piece) {
    const double a = piece.from;
    const double b = piece.from + piece.width;
    const double at_a = curve.slope(a).value;
    const double at_b = curve.slope(b).value;
    if (at_a == 0) return a;
    if (at_b == 0) return b;
    if ((at_a < 0) != (at_b < 0)) return root_in_bracket(curve, a, b, at_a < 0);
    return descend(curve, std::abs(at_a) < std::abs(at_b) ? a : b);
  }
};

}  // namespace bezierbench
