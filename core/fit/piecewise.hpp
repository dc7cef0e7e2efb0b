// SPDX-License-Identifier: MIT
// Makes a piecewise curve of single segments, in the same way for every method. The data are cut at corners. Between
// corners straight data get a straight segment. If the segment of another section is farther than the tolerance from
// any of its points, the section is split at the farthest point, where both parts get the same tangent; likewise if the
// segment leaves the polyline of the data. Splitting ends at sections of two points, which a segment passes without
// error.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/fit/fitting.hpp"
#include "core/fit/polyline.hpp"
#include "core/powers.hpp"

namespace bezierbench {

// The corners of the data and, elsewhere, their tangents. Both are computed from arms: chords to points at a distance
// of two tolerances. Nearer points say more about noise than about the shape: noise of half the tolerance turns two
// arms by less than 2 asin(1/2) = 60 degrees. A corner is sharp for arms of a quarter of that length, too; otherwise it
// is a bend that the data resolve.

/// v / |v|; zero for the zero vector.
template <int Dimension>
Point<double, Dimension> direction_of(const Point<double, Dimension>& v) {
  const double norm = length<Dimension>(v);
  if (!(norm > 0)) return Point<double, Dimension>::Zero();
  Point<double, Dimension> scaled;
  const int exponent = binary_exponent(norm);  // scaled, so that tiny vectors keep their digits
  for (int axis = 0; axis < Dimension; ++axis)
    scaled[axis] = std::ldexp(v[axis], -exponent) / std::ldexp(norm, -exponent);
  return scaled;
}

template <int Dimension>
class Shape {
 public:
  Shape(const FitData<Dimension>& data, double tolerance) : data_(data), arm_(2 * tolerance) {}

  /// Whether the data have a corner, for each point. At a corner the arms turn by more than 75.5 degrees, and no point
  /// between their ends turns more. Arms end at data points and are therefore not all of one length, so that several
  /// points qualify; the one with the largest sum of distances to the ends of the arms is chosen. False for the first
  /// and the last point of open data. In closed data these two are the same point.
  [[nodiscard]] std::vector<bool> corners() const {
    const int first = data_.closed ? 0 : 1;
    std::vector<Turn> turns(static_cast<std::size_t>(data_.count()));
    for (int i = first; i < data_.last(); ++i) turns[static_cast<std::size_t>(i)] = turn_at(i, arm_);
    std::vector<bool> result(turns.size());
    for (int i = first; i < data_.last(); ++i) {
      const Turn& turn = turns[static_cast<std::size_t>(i)];
      bool corner = turn.cosine < sharp_turn;
      for (int k = 1 - turn.before; corner && k < turn.after; ++k)
        corner = turns[static_cast<std::size_t>(around(i + k))].cosine >= turn.cosine;
      if (corner) mark_tips(i, turn, result);
    }
    if (data_.closed) result.back() = result.front();
    return result;
  }

  /// The chord from point `from` to the first point farther than an arm's length in the direction of `to`; to `to`, if
  /// none is, and to the last of `max_steps` points, if the data are dense.
  [[nodiscard]] Point<double, Dimension> chord(int from, int to) const {
    const int step = to > from ? 1 : -1;
    int i = from + step;
    while (i != to && !beyond(from, i, arm_) && std::abs(i - from) < max_steps) i += step;
    return data_.points.col(i) - data_.points.col(from);
  }

 private:
  static constexpr int max_steps = 256;  ///< limits the time for long data, which would be quadratic

  struct Turn {
    double cosine = 1;
    int before = 0;  ///< steps to the ends of the arms
    int after = 0;
  };

  [[nodiscard]] bool beyond(int i, int k, double arm) const {
    return length<Dimension>(data_.points.col(k) - data_.points.col(i)) > arm;
  }

  /// The index of a point. In closed data numbers beyond either end continue at the other.
  [[nodiscard]] int around(int i) const {
    if (!data_.closed) return i;
    return (i + data_.last()) % data_.last();
  }

  /// The number of steps from i to the first point beyond this arm; 0 where there is none.
  [[nodiscard]] int steps_from(int i, int direction, double arm) const {
    for (int k = 1; k <= std::min(max_steps, data_.last() - 1); ++k) {
      const int other = i + direction * k;
      if (!data_.closed && (other < 0 || other > data_.last())) return 0;
      if (beyond(i, around(other), arm)) return k;
    }
    return 0;
  }

  [[nodiscard]] Turn turn_at(int i, double arm) const {
    const int before = steps_from(i, -1, arm);
    const int after = steps_from(i, 1, arm);
    if (before == 0 || after == 0) return {};
    const auto in = direction_of<Dimension>(data_.points.col(i) - data_.points.col(around(i - before)));
    const auto out = direction_of<Dimension>(data_.points.col(around(i + after)) - data_.points.col(i));
    return {dot<Dimension>(in, out), before, after};
  }

  /// Marks the points between the ends of the arms of i for which the sum of the distances to both ends is the largest,
  /// if short arms turn sharply there too.
  void mark_tips(int i, const Turn& turn, std::vector<bool>& corner) const {
    const auto before = data_.points.col(around(i - turn.before));
    const auto after = data_.points.col(around(i + turn.after));
    const auto way_by = [&](int k) {
      const auto point = data_.points.col(around(i + k));
      return length<Dimension>(point - before) + length<Dimension>(point - after);
    };
    double longest = 0;
    for (int k = 1 - turn.before; k < turn.after; ++k) longest = std::max(longest, way_by(k));
    for (int k = 1 - turn.before; k < turn.after; ++k)
      if (way_by(k) == longest && turn_at(around(i + k), arm_ / 4).cosine < sharp_turn)
        corner[static_cast<std::size_t>(around(i + k))] = true;
  }

  const FitData<Dimension>& data_;
  double arm_;
};

template <FittingMethod M, int Dimension>
class Piecewise {
 public:
  using Vector = Point<double, Dimension>;

  /// Prepares the fit that `fit` in kernel.hpp describes.
  Piecewise(std::span<const double> coordinates, double tolerance, const FitEnds& ends)
      : data_(coordinates),
        tolerance_(std::ldexp(tolerance, -data_.exponent)),
        shape_(data_, tolerance_),
        start_(given(ends.start)),
        end_(given(ends.end)),
        limits_(step_limits<Dimension>(data_, tolerance_, start_, end_)) {}

  [[nodiscard]] Fit fit() {
    places_.resize(static_cast<std::size_t>(data_.count()));
    if (data_.count() == 1) append(between_two({0, 0, {}, {}}), {0, 0, {}, {}}, 0);
    for (auto open = sections(); !open.empty();) {
      const Range range = open.back();
      open.pop_back();
      if (const auto split = try_section(range)) {
        open.push_back(split->second);
        open.push_back(split->first);
      }
    }
    for (const int k : data_.index) {
      fit_.segment.push_back(places_[static_cast<std::size_t>(k)].segment);
      fit_.t.push_back(places_[static_cast<std::size_t>(k)].t);
    }
    fit_.max_error = std::ldexp(fit_.max_error, data_.exponent);
    return std::move(fit_);
  }

 private:
  struct Place {
    int segment = 0;
    double t = 0;
  };

  /// A range of points, with tangents at the ends that are smooth joints.
  struct Range {
    int first;
    int last;
    std::optional<Vector> start;  ///< unit tangent into the range; empty at a corner
    std::optional<Vector> end;
  };

  /// A given direction as a unit vector; empty where none is given.
  static std::optional<Vector> given(std::span<const double> direction) {
    if (direction.empty()) return std::nullopt;
    const Vector v = Eigen::Map<const Vector>(direction.data());
    return direction_of<Dimension>(v / largest_coordinate<Dimension>(v));
  }

  /// The ranges between corners, the last one first.
  [[nodiscard]] std::vector<Range> sections() const {
    std::vector<Range> all;
    const auto corners = shape_.corners();
    std::optional<Vector> joint;
    if (data_.closed && !corners.front())
      joint = tangent_between(shape_.chord(data_.last(), 0), shape_.chord(0, data_.last()));
    const auto start = start_ ? start_ : joint;
    const auto end = opposite(end_ ? end_ : joint);
    int last = data_.last();
    for (int i = data_.last() - 1; i >= 0; --i)
      if (i == 0 || corners[static_cast<std::size_t>(i)]) {
        all.push_back({i, last, i == 0 ? start : std::nullopt, last == data_.last() ? end : std::nullopt});
        last = i;
      }
    return all;
  }

  static std::optional<Vector> opposite(std::optional<Vector> v) {
    if (v) *v = -*v;
    return v;
  }

  /// The method's tangent, from the chords to the points before and after; empty where these have no direction.
  static std::optional<Vector> tangent_between(const Vector& to_before, const Vector& to_after) {
    const Vector tangent = direction_of<Dimension>(M::template tangent<Dimension>(-to_before, to_after));
    if (!(squared<Dimension>(tangent) > 0.5)) return std::nullopt;
    return tangent;
  }

  /// Appends the segment of a range, or returns the two ranges to split it into.
  std::optional<std::pair<Range, Range>> try_section(const Range& range) {
    if (range.last - range.first == 1) {
      append(between_two(range), range, 0);
      places_[static_cast<std::size_t>(range.last)] = {fit_.segments(Dimension) - 1, 1};
      return std::nullopt;
    }
    const auto section = section_of(range);
    if (!range.start && !range.end && !append_or_fail(range, section, {straight(range), section.t}))
      return std::nullopt;
    auto piece = M::piece(section);
    fit_.iterations += piece.iterations;
    const auto failure = append_or_fail(range, section, std::move(piece));
    if (!failure) return std::nullopt;
    return split(range, range.first + *failure);
  }

  /// Appends the segment of a section if it keeps the promise. Else returns the number of an inner point where it does
  /// not.
  std::optional<int> append_or_fail(const Range& range, const Section<Dimension>& section, Piece<Dimension> piece) {
    const auto [error, worst] = farthest(section, piece);
    if (!(error <= tolerance_) || !stays_finite(piece.cubic)) return worst;
    if (const auto step = first_departure<Dimension>(section.points, section.limits, piece.cubic, piece.t))
      return *step > 0 ? *step : 1;
    append(piece.cubic, range, error);
    for (std::size_t i = 1; i < piece.t.size(); ++i)
      places_[static_cast<std::size_t>(range.first) + i] = {fit_.segments(Dimension) - 1, piece.t[i]};
    return std::nullopt;
  }

  [[nodiscard]] std::pair<Range, Range> split(const Range& range, int at) const {
    const auto tangent = tangent_between(shape_.chord(at, range.first), shape_.chord(at, range.last));
    return {Range{range.first, at, range.start, opposite(tangent)}, Range{at, range.last, tangent, range.end}};
  }

  [[nodiscard]] Section<Dimension> section_of(const Range& range) const {
    Section<Dimension> section{data_.points.middleCols(range.first, range.last - range.first + 1),
                               {0},
                               0,
                               {limits_.begin() + range.first, limits_.begin() + range.last},
                               end_of(range.start, range.first, range.last),
                               end_of(range.end, range.last, range.first),
                               tolerance_};
    for (Eigen::Index i = 1; i < section.points.cols(); ++i) {
      section.length += length<Dimension>(section.points.col(i) - section.points.col(i - 1));
      section.t.push_back(section.length);
    }
    if (section.length > 0)  // scaling may have made all points equal
      for (double& t : section.t) t /= section.length;
    return section;
  }

  [[nodiscard]] End<Dimension> end_of(const std::optional<Vector>& joint, int from, int to) const {
    return {joint ? *joint : direction_of<Dimension>(shape_.chord(from, to)), joint.has_value()};
  }

  /// A bound of the largest distance, and the number of the inner point that has it. Moves the parameters to foot
  /// points first.
  std::pair<double, int> farthest(const Section<Dimension>& section, Piece<Dimension>& piece) const {
    constexpr int max_steps = 8;
    std::pair<double, int> result{0, static_cast<int>(piece.t.size() / 2)};
    for (std::size_t i = 1; i + 1 < piece.t.size(); ++i) {
      const Vector point = section.points.col(static_cast<Eigen::Index>(i));
      piece.t[i] = approach<Dimension>(piece.cubic, point, piece.t[i], max_steps);
      const double distance = distance_bound<Dimension>(piece.cubic, point, piece.t[i]) + 4 * data_.quantum();
      if (distance > result.first) result = {distance, static_cast<int>(i)};
    }
    piece.t.front() = 0;
    piece.t.back() = 1;
    return result;
  }

  /// The straight segment between the ends of a range.
  [[nodiscard]] Cubic<Dimension> straight(const Range& range) const {
    const Vector first = data_.points.col(range.first);
    const Vector last = data_.points.col(range.last);
    return {first, first + (last - first) / 3, last + (first - last) / 3, last};
  }

  /// The segment between two points: straight unless a joint is smooth. Handles of smooth joints are a third of the
  /// chord, or shorter where the segment would leave it.
  [[nodiscard]] Cubic<Dimension> between_two(const Range& range) const {
    constexpr int max_halvings = 30;
    const auto line = straight(range);
    if (!range.start && !range.end) return line;
    const auto points = data_.points.middleCols(range.first, 2);
    double handle = length<Dimension>(line[3] - line[0]) / 3;
    for (int k = 0; k < max_halvings; ++k, handle /= 2) {
      auto curve = line;
      if (range.start) curve[1] = line[0] + handle * *range.start;
      if (range.end) curve[2] = line[3] + handle * *range.end;
      if (!first_departure<Dimension>(points, {limits_[static_cast<std::size_t>(range.first)]}, curve, {0, 1}))
        return curve;
    }
    return line;
  }

  [[nodiscard]] bool stays_finite(const Cubic<Dimension>& cubic) const {
    for (const auto& control : cubic)
      for (int axis = 0; axis < Dimension; ++axis)
        if (!std::isfinite(std::ldexp(control[axis], data_.exponent))) return false;
    return true;
  }

  /// Appends a segment with the data points at its ends, bit for bit.
  void append(const Cubic<Dimension>& cubic, const Range& range, double error) {
    fit_.max_error = std::max(fit_.max_error, error);
    fit_.converged = fit_.converged && stays_finite(cubic);
    for (std::size_t j = 0; j < cubic.size(); ++j)
      for (int axis = 0; axis < Dimension; ++axis)
        fit_.control_points.push_back(j == 0   ? data_.original(axis, range.first)
                                      : j == 3 ? data_.original(axis, range.last)
                                               : std::ldexp(cubic[j][axis], data_.exponent));
  }

  FitData<Dimension> data_;
  double tolerance_;
  Shape<Dimension> shape_;
  std::optional<Vector> start_;  ///< given directions of the curve, unit vectors
  std::optional<Vector> end_;
  std::vector<double> limits_;  ///< for each step of the polyline, how far from it the curve may be
  std::vector<Place> places_;   ///< for each point of data_, its place on the curve
  Fit fit_;
};

}  // namespace bezierbench
