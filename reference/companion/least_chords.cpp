// SPDX-License-Identifier: MIT
#include "reference/companion/least_chords.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace bezierbench::reference {
namespace {

using ScaledVector = ScaledCurve::Vector;

struct ParameterRange {
  double low;
  double high;
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  [[nodiscard]] double width() const { return high - low; }
};

/// Starts and ends of chords.
struct ChordBox {
  ParameterRange a;
  ParameterRange b;
};

constexpr double first_reach = 0x1p-10;

class ReachSearch {
 public:
  ReachSearch(const ScaledCurve& curve, double tolerance)
      : curve_(curve), tolerance_(curve.scaled(tolerance)), slack_(curve.slack()) {}

  /// Whether the chord is certainly within the tolerance.
  bool is_within(double a, double b) {
    curve_.piece(a, b, piece_);
    const ScaledVector from = affine(piece_.front());
    const ScaledVector to = affine(piece_.back());
    const auto is_near = [&](const ScaledCurve::Homogeneous& point) {
      return distance_to_segment(affine(point), from, to) + slack_ <= tolerance_;
    };
    if (is_in_hull(piece_) && std::ranges::all_of(piece_, is_near)) return true;
    return largest_distance(piece_, from, to, tolerance_, slack_).high <= tolerance_;
  }

  /// The farthest b that doubling `step` and bisection find to be within the tolerance of a.
  double reach(double a, double step) {
    if (is_within(a, 1)) return 1;
    double low = a;
    double high = 1;
    for (; low + step < 1; step *= 2) {
      if (!is_within(a, low + step)) {
        high = low + step;
        break;
      }
      low += step;
    }
    while (high - low > 0x1p-12 * (high - a) && high - low > 0x1p-45) {
      const double middle = 0.5 * (low + high);
      (is_within(a, middle) ? low : high) = middle;
    }
    return low;
  }

  /// An upper bound of the b that chords from a in `starts` reach, at least starts.high.
  double bound(ParameterRange starts, double step) {
    const auto nearer = [](const ChordBox& one, const ChordBox& other) { return one.b.high < other.b.high; };
    std::priority_queue<ChordBox, std::vector<ChordBox>, decltype(nearer)> boxes(nearer);
    const auto add = [&](const ChordBox& box) {
      if (!is_excluded(box)) boxes.push(box);
    };
    add({starts, {starts.high, 1}});
    const double finest = std::max(step * 0x1p-10, 0x1p-45);
    for (int taken = 0; !boxes.empty(); ++taken) {
      const ChordBox box = boxes.top();
      if ((box.b.width() <= finest && box.a.width() <= finest) || taken == most_boxes) return box.b.high;
      boxes.pop();
      if (box.b.width() >= box.a.width()) {
        add({box.a, {box.b.low, box.b.middle()}});
        add({box.a, {box.b.middle(), box.b.high}});
      } else {
        add({{box.a.low, box.a.middle()}, box.b});
        add({{box.a.middle(), box.a.high}, box.b});
      }
    }
    return starts.high;
  }

 private:
  static constexpr int most_boxes = 20000;

  bool is_excluded(const ChordBox& box) {
    if (box.b.low <= box.a.high) return false;
    const ScaledVector from = curve_.point(box.a.middle());
    const ScaledVector to = curve_.point(box.b.middle());
    if (!find_hull(box.a, starts_) || !find_hull(box.b, ends_)) return false;
    constexpr int samples = 8;
    double best = 0;
    int at = 0;
    std::array<double, samples + 1> distances{};
    const ParameterRange inner{box.a.high, box.b.low};
    const auto t_of = [&](double k) { return inner.low + inner.width() * (k / samples); };
    for (int k = 0; k <= samples; ++k) {
      const double distance = distance_to_segment(curve_.point(t_of(k)), from, to);
      distances[static_cast<std::size_t>(k)] = distance;
      if (distance > best) {
        best = distance;
        at = k;
      }
    }
    double place = at;
    if (at > 0 && at < samples) {  // the vertex of a parabola through the largest and its neighbours
      const double before = distances[static_cast<std::size_t>(at) - 1];
      const double after = distances[static_cast<std::size_t>(at) + 1];
      const double bend = before - 2 * best + after;
      if (bend < 0) place += 0.5 * (before - after) / bend;
    }
    return excludes(curve_.point(t_of(std::clamp(place, 0.0, 1.0 * samples))), from, to) ||
           (place != at && excludes(curve_.point(t_of(at)), from, to));
  }

  /// The control points of the piece; false where they do not contain it.
  bool find_hull(const ParameterRange& range, std::vector<ScaledVector>& control_points) {
    curve_.piece(range.low, range.high, piece_);
    control_points.clear();
    for (const auto& point : piece_) control_points.push_back(affine(point));
    return is_in_hull(piece_);
  }

  /// Whether the point is certainly beyond the tolerance of all chords from the hull of starts_ to that of ends_.
  [[nodiscard]] bool excludes(const ScaledVector& point, const ScaledVector& from, const ScaledVector& to) const {
    ScaledVector chord;
    double along = 0;
    double squared_length = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      chord[axis] = to[axis] - from[axis];
      along += (point[axis] - from[axis]) * chord[axis];
      squared_length += chord[axis] * chord[axis];
    }
    const double part = along <= 0 ? 0 : along >= squared_length ? 1 : along / squared_length;
    ScaledVector direction;
    double length = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      direction[axis] = point[axis] - (from[axis] + part * chord[axis]);
      length += direction[axis] * direction[axis];
    }
    length = std::sqrt(length);
    if (!(length > tolerance_)) return false;
    for (auto& coordinate : direction) coordinate /= length;
    double nearest = 4;  // least direction.(point - X)
    for (const auto* hull : {&starts_, &ends_})
      for (const auto& x : *hull) {
        double height = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) height += direction[axis] * (point[axis] - x[axis]);
        nearest = std::min(nearest, height);
      }
    return nearest - slack_ > tolerance_;
  }

  const ScaledCurve& curve_;
  double tolerance_;
  double slack_;
  std::vector<ScaledCurve::Homogeneous> piece_;
  std::vector<ScaledVector> starts_;
  std::vector<ScaledVector> ends_;
};

/// Chords from t = 0 on, each as long as it can be; at most `most_counted`.
int greedy_count(ReachSearch& search) {
  double a = 0;
  double step = first_reach;
  for (int count = 1; count < most_counted; ++count) {
    const double b = search.reach(a, step);
    if (b >= 1) return count;
    step = b - a;
    a = b;
    if (step <= 0) break;
  }
  return most_counted;
}

}  // namespace

LeastChords least_chords(const ScaledCurve& curve, double tolerance) {
  ReachSearch search(curve, tolerance);
  const int high = greedy_count(search);
  int low = 1;
  double step = first_reach;
  for (ParameterRange starts{0, 0}; low < high; ++low) {
    step = std::max(search.reach(starts.high, step) - starts.high, 0x1p-40);
    starts = {starts.high, search.bound(starts, step)};
    if (starts.high >= 1) break;
  }
  return {low, high};
}

}  // namespace bezierbench::reference
