// SPDX-License-Identifier: MIT
// The search of quintic_isolate for the roots of f = (C - P).C' / n. The signs of the coefficients of f bound the
// number of roots of a piece; the curve is halved until each piece has one root or none. Where f falls from plus to
// minus the distance is largest, so that such a root is counted but not computed.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

#include "core/project/polygon.hpp"
#include "core/project/polygon_product.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

// A first estimate of the only root of a polynomial in Bernstein form: the zero of its control polygon, then Newton
// steps until the estimate is so near that few steps on the curve itself remain.
//
// Source: [Moerken and Reimers 2007], zeros of the control polygon as estimates.
// Cost: 3 flops for each of the n(n+1)/2 points of de Casteljau's triangle per step; most often three or four steps.

/// The value of f, and its derivative divided by the degree n.
struct BernsteinSlope {
  double value;
  double derivative;
};

/// Evaluates f at t by de Casteljau's algorithm, whose last level but one gives the derivative. The degree is at least
/// 1.
template <int Points>
BernsteinSlope bernstein_slope(Polygon<1, Points> f, double t) {
  const double s = 1 - t;
  each_of_triangle<count_of(Points, -1), 2>(degree_of<1>(f), [&](int i) { f[i] = s * f[i] + t * f[i + 1]; });
  return {s * f[0] + t * f[1], f[1] - f[0]};
}

/// The parameter at which the control polygon of f first crosses zero. Its first and last coefficient have different
/// signs.
template <int Points>
double zero_of_control_polygon(const Polygon<1, Points>& f) {
  int k = 0;
  while ((f[k + 1] < 0) == (f[0] < 0)) ++k;
  return (k + f[k] / (f[k] - f[k + 1])) / degree_of<1>(f);
}

/// An estimate of the root of f in (0, 1). The first and last coefficient of f have different signs. The estimate has
/// no guaranteed accuracy: next to the root, values of f may consist of rounding errors only.
template <int Points>
RootEstimate estimate_root(const Polygon<1, Points>& f) {
  constexpr int max_steps = 16;
  constexpr double short_step = 0x1p-18;
  RootEstimate root{zero_of_control_polygon(f), 1};
  for (int k = 0; k < max_steps && std::abs(root.step) > short_step; ++k) {
    const auto [value, derivative] = bernstein_slope(f, root.t);
    const double next = root.t - value / (degree_of<1>(f) * derivative);
    if (!(next > 0 && next < 1)) return {root.t, 1};
    root = {next, next - root.t};
  }
  return root;
}

/// One search for one curve and one point. The degree is known at compile time, or dynamic.
template <int Dimension, int Degree = dynamic>
class Isolation {
 public:
  Isolation(const Curve<Form::bernstein, double, Dimension>& curve, const Point<double, Dimension>& point)
      : offset_(curve, point), product_(offset_.degree()) {
    candidates_.reserve(room_.size() / sizeof(double));
  }
  Isolation(const Isolation&) = delete;
  Isolation& operator=(const Isolation&) = delete;

  FootPoint foot() {
    isolate({HalvedPolygon(offset_.offsets()), HalvedPolygon(offset_.differences_of_points())});
    const auto best = nearest_neighbour(offset_, nearest_candidate(offset_, std::move(candidates_)));
    const FootPoint foot{best.t, offset_.unscaled(best.scaled_distance), best.candidates + maxima_,
                         judged_ < max_pieces};
    if (best.t > 0 && best.t < 1) return foot;
    const double t = polished(offset_, best.t);  // a root so near to the end that it is not farther away
    return t == best.t ? foot : FootPoint{t, offset_.distance(t), foot.candidates, foot.converged};
  }

 private:
  static constexpr int max_pieces = 20'000;
  static constexpr double smallest_width = 0x1p-60;

  /// A part of the curve, divided by m as in OffsetCurve.
  struct Piece {
    HalvedPolygon<Dimension, count_of(Degree, 1)> offset;  ///< control points of C - P
    HalvedPolygon<Dimension, Degree> difference;  ///< control points of C' / n, in the parameter of the whole curve
    double from = 0;
    double width = 1;

    [[nodiscard]] double middle() const { return from + width / 2; }
  };

  /// Adds a candidate for each root in the piece.
  void isolate(const Piece& piece) {
    if (judged_ == max_pieces) {
      candidates_.push_back(polished(offset_, piece.middle()));
      return;
    }
    ++judged_;
    const auto f = product_(piece.offset, piece.difference);
    const int most = f.max_variations();
    if (most == 0) return;
    if (most == 1 && f.sign(0) > 0 && f.sign(f.degree()) < 0)
      ++maxima_;
    else if (f.is_unknown() || piece.width < smallest_width)
      candidates_.push_back(polished(offset_, piece.middle()));
    else if (most == 1)
      candidates_.push_back(root_of(piece, f));
    else
      isolate_halves(piece);
  }

  void isolate_halves(const Piece& piece) {
    Piece left;
    Piece right;
    halve(piece.offset, left.offset, right.offset);
    halve(piece.difference, left.difference, right.difference);
    left.from = piece.from;
    right.from = piece.middle();
    left.width = right.width = piece.width / 2;
    isolate(left);
    isolate(right);
  }

  /// The root in a piece that has at most one. Where f has the same sign at both ends, the root, if there is one, lies
  /// at an end up to rounding.
  double root_of(const Piece& piece, const UncertainPolynomial<count_of(Degree, Degree)>& f) const {
    const double a = piece.from;
    const double b = a + piece.width;
    if (f.sign(0) != 0 && f.sign(f.degree()) != 0) {
      const auto estimate = estimate_root(f.coefficients());
      return root_in_bracket(offset_, a, b, f.sign(0) < 0, {a + piece.width * estimate.t, piece.width * estimate.step});
    }
    const double at_a = offset_.slope(a).value;
    const double at_b = offset_.slope(b).value;
    if (at_a == 0) return a;
    if (at_b == 0) return b;
    if ((at_a < 0) != (at_b < 0)) return root_in_bracket(offset_, a, b, at_a < 0, {piece.middle(), piece.width});
    return polished(offset_, std::abs(at_a) < std::abs(at_b) ? a : b);
  }

  OffsetCurve<Dimension, Degree> offset_;
  PolygonProduct<Degree> product_;
  std::array<std::byte, 64 * sizeof(double)> room_;  // avoids an allocation for curves of low degree
  std::pmr::monotonic_buffer_resource memory_{room_.data(), room_.size()};
  std::pmr::vector<double> candidates_{&memory_};
  int judged_ = 0;
  int maxima_ = 0;  ///< roots at which the distance is largest, which are never the nearest
};

}  // namespace bezierbench
