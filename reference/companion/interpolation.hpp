// SPDX-License-Identifier: MIT
// The truth about C2 cubic splines, one axis at a time. Of natural ones at uniform
// parameters: the residuals of given Bezier segments in each of the conditions, and the exact spline, in big integers
// over one power of two. Of any other: the exact spline in fractions.
#pragma once

#include <span>
#include <vector>

#include "reference/rational.hpp"

namespace bezierbench::reference {

/// The exact inner control points: segment i is K_i, first[i], second[i], K_(i+1).
struct ExactSpline {
  std::vector<Rational> first;
  std::vector<Rational> second;
};

/// The exact spline for n + 1 >= 2 finite coordinates K. The system of the handles is solved by shooting: with a_0 =
/// P1,0 unknown, its equations give a_1, a_2, ... as p_i + q_i a_0 with integers p_i and q_i, and the last one gives
/// a_0. That takes O(n^2) bits, so it suits n up to several thousand.
ExactSpline exact_spline(std::span<const double> coordinates);

/// What a C2 cubic spline is to meet beside its points.
struct SplineSystem {
  enum class Ends { natural, clamped, not_a_knot, closed };
  std::span<const double> steps;  ///< of the parameter, one for each segment, positive
  Ends ends = Ends::natural;
  double start = 0;  ///< of clamped ends: 3 (P1 - P0) of the first segment
  double end = 0;    ///< and 3 (P3 - P2) of the last
};

/// The exact spline through K_0 ... K_n, where n is the number of steps; of a closed one K_n = K_0. It is found from
/// its definition: continuous first and second derivatives by the parameter at each knot, and the two conditions of the
/// ends; not-a-knot ends of two segments are those of one parabola, of one segment those of a line. Inner control
/// points are the unknowns, eliminated densely in O(n^3) fractions, so it suits n up to some dozens.
ExactSpline exact_spline(std::span<const double> coordinates, const SplineSystem& system);

/// The largest magnitudes along the spline, exact.
struct SplineResiduals {
  Rational data;     ///< largest of P0,i - K_i and P3,i - K_(i+1)
  Rational c0;       ///< largest of P0,i - P3,i-1
  Rational c1;       ///< largest of (P1,i - P0,i) - (P3,i-1 - P2,i-1)
  Rational c2;       ///< largest of (P0,i - 2 P1,i + P2,i) - (P1,i-1 - 2 P2,i-1 + P3,i-1)
  Rational natural;  ///< largest of P0,0 - 2 P1,0 + P2,0 and P1,n-1 - 2 P2,n-1 + P3,n-1
};

/// The residuals of segments through n + 1 >= 2 finite coordinates; `segments` has 4n finite ones, segment by segment.
SplineResiduals spline_residuals(std::span<const double> coordinates, std::span<const double> segments);

/// The largest |P - exact P| of the inner control points of those segments.
Rational inner_point_error(const ExactSpline& exact, std::span<const double> segments);

}  // namespace bezierbench::reference
