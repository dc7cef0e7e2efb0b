// SPDX-License-Identifier: MIT
// Formula: the C2 cubic spline by its slopes m_i at parameters with steps h_i; with l_i = h_i / (h_(i-1) + h_i) and
//   chords s_i = (K_(i+1) - K_i) / h_i,
//     l_i m_(i-1) + 2 m_i + (1 - l_i) m_(i+1) = 3 (l_i s_(i-1) + (1 - l_i) s_i),
//   then P1,i = K_i + h_i m_i / 3 and P2,i = K_(i+1) - h_i m_(i+1) / 3. Ends: natural, 2 m_0 + m_1 = 3 s_0; clamped,
//   m_0 is given; not a knot, the first two segments are one cubic (two segments in all: both have degree 2, as one
//   parabola has). A closed spline has the system without ends, cyclic; it is solved for m_0 = 0 and m_0 = 1.
//   Monotone: each slope is moved into 0 ... 3 times the smaller of both chords, or to 0 where these differ in sign.
//   Then every coordinate is monotone in every segment, which is C1 only.
// Source: [de Boor 1978], chapter IV. The limits of monotone slopes are those of [Hyman 1983]; that they suffice is
//   shown in [Fritsch and Carlson 1980].
// Cost: 25 flops per point and axis.
// Bound: none; rows are diagonally dominant except at not-a-knot ends, so that elimination without pivoting is stable.
// Keeps: a natural spline through points that ascend on a line is monotone for centripetal and for chord-length
//   parameters; for these it is the line itself. Proof for centripetal ones: s_i = h_i up to a factor, so that the
//   equations are L_(i-1) + 2 R_(i-1) + 2 L_i + R_i = 6 with L_i = m_i / s_i, R_i = m_(i+1) / s_i, and 2 L_0 + R_0 = 3.
//   Elimination from the left gives L_i = b (6 - a) - b R_i with the a of the knot before, 0 < b <= 1/2 and so 0 <= a
//   <= 3; from the right likewise for R_i. The two lines meet where L_i >= 0, as 6 - a >= 3. All slopes are at least 0,
//   therefore each of the four terms is at most 6, so that L and R are at most 3.
// Fails: uniform parameters, where distances of neighbours differ much: the curve runs back and makes loops.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace bezierbench {

enum class SplineEnds { natural, clamped, not_a_knot };

inline constexpr std::array<std::string_view, 3> spline_ends_names{"natural", "clamped", "not-a-knot"};

struct SplineConditions {
  SplineEnds ends = SplineEnds::natural;
  bool closed = false;    ///< periodic; there are no ends then
  bool monotone = false;  ///< every coordinate within every segment, at the price of C2
  /// Of clamped ends, one number per axis: the derivatives of the first segment at its beginning and of the last at its
  /// end, by the parameter from 0 to 1 of the segment: 3 (P1 - P0) and 3 (P3 - P2).
  std::span<const double> start_derivative{};
  std::span<const double> end_derivative{};
};

/// The cubic Bezier segments of the spline, point by point, four control points each; one segment for each of `steps`,
/// which are positive (see knot_steps()). Without `closed` there is one point more than steps; with it as many, at
/// least 2, and the last segment ends in the first point. Each point has `dimension` finite coordinates, and is met bit
/// for bit. An inner control point beyond the largest double is infinite. Where all steps are 1, the spline of natural
/// ends is that of the first method of the roster, with its bound.
std::vector<double> spline_segments(std::span<const double> points, int dimension, std::span<const double> steps,
                                    const SplineConditions& conditions);

// Formula: the steps between the parameters of points: h_i = |K_(i+1) - K_i|^e, where e is 0 for uniform, 1/2 for
//   centripetal and 1 for chord-length parameters.
// Source: [Lee 1989].

/// The first is the default of commands; spline.hpp has the reason.
enum class Parameters { centripetal, uniform, chord };

inline constexpr std::array<std::string_view, 3> parameters_names{"centripetal", "uniform", "chord"};

/// The steps over the largest of them. Points are n + 1 >= 2, or n >= 2 of a closed curve, whose last step goes back to
/// the first point; `dimension` finite coordinates each. A step is 0 where points coincide, also where its length is
/// below 2^-900 of the largest. Uniform steps are 1.
std::vector<double> knot_steps(std::span<const double> points, int dimension, Parameters parameters, bool closed);

}  // namespace bezierbench
