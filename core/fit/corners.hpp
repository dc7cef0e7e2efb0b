// SPDX-License-Identifier: MIT
// The corners of the data and, elsewhere, their tangents. Both are computed from arms: chords to points at a distance
// of two tolerances. Nearer points say more about noise than about the shape: noise of half the tolerance turns two
// arms by less than 2 asin(1/2) = 60 degrees. A corner is sharp for arms of a quarter of that length, too; otherwise it
// is a bend that the data resolve.
#pragma once

#include <vector>

#include "core/fit/fit_data.hpp"
#include "core/fit/polyline.hpp"
#include "core/powers.hpp"

namespace bezierbench {

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

}  // namespace bezierbench
