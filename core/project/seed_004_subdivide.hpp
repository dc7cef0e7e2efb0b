// SPDX-License-Identifier: MIT
// Formula: halves the curve and drops pieces as [Document 004] says: a piece whose nearest vertex, control point or
//   end, is farther from P than the farthest vertex of another piece. After 16 rounds the nearest end of a piece is
//   taken, and polished, so that what is missed is the fault of the pruning alone.
// Source: a baseline for subdivide_hull. The document halves until the error is negligible.
// Cost: some 100 pieces, and more where many points are about equally near.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: the distance of the vertices is not a lower bound of that of the curve, which passes between them. (6,3) (5,6)
//   (-7,-2) (7,4) and P = (5,3) have the nearest point at t = 0.945677, distance 0.15324. It is dropped after four
//   rounds; the nearest of what is left is 0.680 away. Such curves are rare: suite projection counts them in its column
//   `missed`, most where the point is on the curve.
#pragma once

#include <limits>
#include <vector>

#include "core/project/kernel.hpp"
#include "core/project/refine.hpp"

namespace bezierbench {

struct Seed004Subdivide {
  static constexpr int rounds = 16;
  static constexpr std::size_t max_pieces = 4096;  ///< at once; where the whole curve is about equally near

  static constexpr MethodInfo info{.id = "seed_004_subdivide",
                                   .label = "Subdivision pruned by vertices, as printed",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .flops = "d n(n+1) per piece",
                                   .cost_exponent = 2,
                                   .citation = "[Document 004], third answer"};
  static constexpr auto residual_bound = polished_residual_bound;

  template <int Dimension>
  static FootPoint project(const Curve<Form::bernstein, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    const OffsetCurve<Dimension> offset(curve, point);
    std::vector<Piece<Dimension>> active{{offset.offsets(), 0}};
    int judged = 1;
    double width = 1;
    for (int round = 0; round < rounds && active.size() <= max_pieces; ++round) {
      width /= 2;
      active = halved(active, width);
      judged += static_cast<int>(active.size());
      prune(active);
    }
    double t = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& piece : active)
      for (const bool last : {false, true}) {
        const double distance = length<Dimension>(piece.offset.col(last ? piece.offset.cols() - 1 : 0));
        if (!(distance < least)) continue;
        least = distance;
        t = piece.from + (last ? width : 0);
      }
    t = polished(offset, t);
    return {t, offset.distance(t), judged, active.size() <= max_pieces};
  }

 private:
  template <int Dimension>
  struct Piece {
    Polygon<Dimension> offset;  ///< control points of C - P, over m as in OffsetCurve
    double from;
    double nearest = 0;  ///< distance of the nearest vertex, and of the farthest
    double farthest = std::numeric_limits<double>::infinity();
  };

  template <int Dimension>
  static std::vector<Piece<Dimension>> halved(const std::vector<Piece<Dimension>>& pieces, double width) {
    std::vector<Piece<Dimension>> halves;
    for (const auto& piece : pieces) {
      Piece<Dimension> left{{}, piece.from};
      Piece<Dimension> right{{}, piece.from + width};
      halve<Dimension>(piece.offset, left.offset, right.offset);
      halves.push_back(std::move(left));
      halves.push_back(std::move(right));
    }
    return halves;
  }

  template <int Dimension>
  static void prune(std::vector<Piece<Dimension>>& pieces) {
    double limit = std::numeric_limits<double>::infinity();
    for (auto& piece : pieces) {
      piece.nearest = std::numeric_limits<double>::infinity();
      piece.farthest = 0;
      for (Eigen::Index i = 0; i < piece.offset.cols(); ++i) {
        const double distance = length<Dimension>(piece.offset.col(i));
        piece.nearest = std::min(piece.nearest, distance);
        piece.farthest = std::max(piece.farthest, distance);
      }
      limit = std::min(limit, piece.farthest);
    }
    std::erase_if(pieces, [limit](const auto& piece) { return piece.nearest > limit; });
  }
};

}  // namespace bezierbench
