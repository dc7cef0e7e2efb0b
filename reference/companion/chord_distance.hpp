// SPDX-License-Identifier: MIT
// How far a piece of a curve with control points is from a chord: an enclosure, proved, and whether it is within a
// tolerance, decided by exact arithmetic where the enclosure does not decide.
//
// The one-sided distance is the largest distance of a point of the piece from the chord, a segment. The Hausdorff
// distance also counts the points of the chord. It is at most the larger one of the one-sided distance and the
// distances of the chord's ends from those of the piece: between the feet of its ends, every point of the chord is the
// foot of a point of the piece, by continuity, and one outside is not farther from the end of the piece than its own
// end. So the enclosure [low, high] has the one-sided distance from below and the Hausdorff distance from above.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::reference {

/// A number lies between the two.
struct Enclosure {
  double low;
  double high;
};

enum class Kept {
  proved,    ///< the Hausdorff distance is at most the tolerance
  refuted,   ///< a point of the piece is farther than the tolerance
  undecided  ///< nearer to the tolerance than what the exact subdivision sees
};

struct ChordJudgement {
  Enclosure distance;
  Kept kept;
};

/// Points and pieces of a curve, times a power of two that brings its largest coordinate into [1/2, 1). Every computed
/// coordinate or distance is off by at most `slack`: n levels of three roundings for a blossom, 30 halvings of n levels
/// of one rounding, and at most 60 roundings for a distance, all of numbers below 4, on each axis. Of a rational curve
/// the numerator V and the denominator W have these errors, over sum |w_i| B_i, and V / W has
/// (|dV| + |V/W| |dW|) / |W|. Where weights have two signs, let g be the largest |w_i| over the least |W|: |V/W| <= g,
/// so that `slack` is larger by g (1 + g).
class ScaledCurve {
 public:
  using Vector = std::array<double, 3>;
  using Homogeneous = std::array<double, 4>;  ///< coordinates times the weight, and the weight: 1 if not rational

  /// Finite control points, dimension at most 3, in Bernstein form or in rational form without a pole in [0, 1]. Where
  /// weights are more than 2^900 apart, `slack` is infinite, and nothing is decided. `curve` must outlive this object.
  explicit ScaledCurve(const CurveView<double>& curve);

  [[nodiscard]] int degree() const { return curve_.degree; }
  [[nodiscard]] double slack() const { return slack_; }
  /// A coordinate or distance times the power of two.
  [[nodiscard]] double scaled(double value) const;
  [[nodiscard]] double unscaled(double value) const;
  [[nodiscard]] Vector scaled(std::span<const double> point) const;
  [[nodiscard]] Vector point(double t) const;
  /// The control points of the piece over [from, to], 0 <= from <= to <= 1.
  void piece(double from, double to, std::vector<Homogeneous>& control_points) const;
  [[nodiscard]] const CurveView<double>& given() const { return curve_; }

 private:
  CurveView<double> curve_;
  int exponent_;
  double slack_;
  std::size_t axes_;  ///< of the homogeneous coordinates that are computed: without weights the last one stays 1
  std::vector<Homogeneous> control_points_;
  mutable std::vector<Homogeneous> work_;
};

/// A control point from its homogeneous coordinates.
ScaledCurve::Vector affine(const ScaledCurve::Homogeneous& point);

/// Whether all weights have one sign, so that the points are in the hull of the control points.
bool is_in_hull(const std::vector<ScaledCurve::Homogeneous>& control_points);

/// The distance of `point` from the segment between the other two.
double distance_to_segment(const ScaledCurve::Vector& point, const ScaledCurve::Vector& from,
                           const ScaledCurve::Vector& to);

/// An enclosure of the largest distance of the piece with these control points from the segment; all scaled. Ends where
/// the width is at most 2^-10 of the distance or the slack, and `tolerance` is outside or that near.
Enclosure largest_distance(std::vector<ScaledCurve::Homogeneous> control_points, const ScaledCurve::Vector& from,
                           const ScaledCurve::Vector& to, double tolerance, double slack);

/// Judges the piece over [t_from, t_to], a part of [0, 1], and the chord between two points.
ChordJudgement judge_chord(const ScaledCurve& curve, double t_from, double t_to, std::span<const double> from,
                           std::span<const double> to, double tolerance);

// The least number of chords, with ends on the curve and ascending parameters, whose pieces are all within a tolerance.
//
// From below: no k chords reach beyond R_k, where R_0 = 0 and R_(k+1) is an upper bound of the b for which some a <=
// R_k has a chord (a, b) within the tolerance. Chords with a <= R_(k-1) end before R_k. The rest is a search over boxes
// of a and b, farthest b first: a box is excluded if for one t between its a and b and one unit vector v, v.C(t) is
// above v.X by more than the tolerance for all X of the hulls of both pieces, over the box's a and over its b. A chord
// of the box is inside the hull of these two.
// From above: a flattening that is proved to be within the tolerance.

struct LeastChords {
  int low;
  int high;
};

/// Tolerance above 0, in coordinate units. Both numbers are at most `most_counted`, which stands for more, too.
inline constexpr int most_counted = 4096;
LeastChords least_chords(const ScaledCurve& curve, double tolerance);

}  // namespace bezierbench::reference
