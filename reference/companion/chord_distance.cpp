// SPDX-License-Identifier: MIT
#include "reference/companion/chord_distance.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "reference/companion/exact_roots.hpp"

namespace bezierbench::reference {

namespace {

using Scaled = ScaledCurve::Vector;
using Lifted = ScaledCurve::Homogeneous;

template <class Point>
Point step_between(const Point& a, const Point& b) {
  Point difference;
  for (std::size_t axis = 0; axis < a.size(); ++axis) difference[axis] = a[axis] - b[axis];
  return difference;
}

template <class Point>
auto dot_product_of(const Point& a, const Point& b) {
  typename Point::value_type sum = a[0] * b[0];
  for (std::size_t axis = 1; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// Halves the control points into left and right, by the triangle.
template <class Point>
void halve_piece(std::vector<Point>& left, std::vector<Point>& right) {
  right = left;
  const std::size_t n = left.size() - 1;
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = 0; i + k <= n; ++i)
      for (std::size_t axis = 0; axis < right[i].size(); ++axis)
        right[i][axis] = (right[i][axis] + right[i + 1][axis]) / 2;
    left[k] = right[0];
  }
}

using ExactTriple = std::array<mpq_class, 3>;
using ExactLifted = std::array<mpq_class, 4>;

template <class Point>
auto over_weight(const Point& lifted) {
  std::array<typename Point::value_type, 3> point;
  for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] = lifted[axis] / lifted[3];
  return point;
}

template <class Point>
bool weights_have_one_sign(const std::vector<Point>& control_points) {
  const auto is_positive = [](const Point& point) { return point[3] > 0; };
  const auto is_negative = [](const Point& point) { return point[3] < 0; };
  return std::ranges::all_of(control_points, is_positive) || std::ranges::all_of(control_points, is_negative);
}

/// The square of the distance from the segment.
mpq_class squared_distance(const ExactTriple& point, const ExactTriple& from, const ExactTriple& to) {
  const auto chord = step_between(to, from);
  const auto offset = step_between(point, from);
  const mpq_class along = dot_product_of(offset, chord);
  const mpq_class squared_length = dot_product_of(chord, chord);
  if (along <= 0) return dot_product_of(offset, offset);
  if (along >= squared_length) {
    const auto beyond = step_between(point, to);
    return dot_product_of(beyond, beyond);
  }
  return dot_product_of(offset, offset) - along * along / squared_length;
}

ExactTriple exact_vector(std::span<const double> point) {
  ExactTriple exact;
  std::copy(point.begin(), point.end(), exact.begin());
  return exact;
}

/// The blossom's values: control point j of the piece takes t_to j times and t_from else.
std::vector<ExactLifted> exact_piece(const CurveView<double>& curve, double t_from, double t_to) {
  const auto n = static_cast<std::size_t>(curve.degree);
  const auto d = static_cast<std::size_t>(curve.dimension);
  std::vector<ExactLifted> piece;
  for (std::size_t j = 0; j <= n; ++j) {
    std::vector<ExactLifted> b;
    for (std::size_t i = 0; i <= n; ++i) {
      const mpq_class weight(curve.weights.empty() ? 1 : curve.weights[i]);
      auto& lifted = b.emplace_back();
      for (std::size_t axis = 0; axis < d; ++axis) lifted[axis] = weight * mpq_class(curve.coefficients[i * d + axis]);
      lifted[3] = weight;
    }
    for (std::size_t k = 1; k <= n; ++k) {
      const mpq_class t(k <= j ? t_to : t_from);
      for (std::size_t i = 0; i + k <= n; ++i)
        for (std::size_t axis = 0; axis < 4; ++axis) b[i][axis] += t * (b[i + 1][axis] - b[i][axis]);
    }
    piece.push_back(b.front());
  }
  return piece;
}

Kept judge_exactly(const CurveView<double>& curve, double t_from, double t_to, std::span<const double> from,
                   std::span<const double> to, double tolerance) {
  const auto start = exact_vector(from);
  const auto end = exact_vector(to);
  const mpq_class square = mpq_class(tolerance) * mpq_class(tolerance);
  std::vector<std::vector<ExactLifted>> pieces{exact_piece(curve, t_from, t_to)};
  const auto apart = [&](const ExactTriple& a, const ExactTriple& b) {
    const auto difference = step_between(a, b);
    return dot_product_of(difference, difference) > square;
  };
  const bool ends_apart =
      apart(over_weight(pieces.front().front()), start) || apart(over_weight(pieces.front().back()), end);
  const auto beyond = [&](const ExactLifted& lifted) {
    return squared_distance(over_weight(lifted), start, end) > square;
  };
  constexpr int most_pieces = 500;
  int taken = 0;
  while (!pieces.empty()) {
    auto left = std::move(pieces.back());
    pieces.pop_back();
    if (beyond(left.front()) || beyond(left.back())) return Kept::refuted;
    if (weights_have_one_sign(left) && std::ranges::none_of(left, beyond)) continue;
    if (++taken > most_pieces) return Kept::undecided;
    std::vector<ExactLifted> right;
    halve_piece(left, right);
    pieces.push_back(std::move(left));
    pieces.push_back(std::move(right));
  }
  return ends_apart ? Kept::undecided : Kept::proved;
}

/// Of a power of two that all numbers are below; 0 if they are 0.
int largest_exponent(std::span<const double> numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

/// 1 for weights of one sign, else g (1 + g) with a bound g of sum |w_i| B_i / |W| over [0, 1], the weights being below
/// 1; infinite where they are too far apart for doubles.
double growth_of_errors(const CurveView<double>& curve, const std::vector<Lifted>& control_points) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> weights;
  for (const auto& point : control_points) {
    weights.push_back(point[3]);
    if (point[3] != 0) least = std::min(least, std::abs(point[3]));
  }
  if (least < 0x1p-900 || std::ranges::count(weights, 0.0) != std::ranges::count(curve.weights, 0.0))
    return std::numeric_limits<double>::infinity();
  if (weights_have_one_sign(control_points)) return 1;
  const auto [low, high] = exact_range({Form::bernstein, 1, curve.degree, weights}, 0);
  const double g = 1 / std::max(low, -high);
  return g * (1 + g);
}

}  // namespace

ScaledCurve::ScaledCurve(const CurveView<double>& curve)
    : curve_(curve), exponent_(0), slack_(std::ldexp(curve.degree + 2.0, -46)), axes_(curve.weights.empty() ? 3 : 4) {
  exponent_ = largest_exponent(curve.coefficients);
  const auto d = static_cast<std::size_t>(curve.dimension);
  const int of_weights = curve.weights.empty() ? 0 : largest_exponent(curve.weights);
  for (std::size_t i = 0; i * d < curve.coefficients.size(); ++i) {
    const auto point = scaled(curve.coefficients.subspan(i * d, d));
    const double w = curve.weights.empty() ? 1 : std::ldexp(curve.weights[i], -of_weights);
    control_points_.push_back({w * point[0], w * point[1], w * point[2], w});
  }
  if (!curve.weights.empty()) slack_ *= growth_of_errors(curve, control_points_);
}

double ScaledCurve::scaled(double value) const { return std::ldexp(value, -exponent_); }
double ScaledCurve::unscaled(double value) const { return std::ldexp(value, exponent_); }

Scaled ScaledCurve::scaled(std::span<const double> point) const {
  Scaled result{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) result[axis] = scaled(point[axis]);
  return result;
}

Scaled ScaledCurve::point(double t) const {
  work_ = control_points_;
  for (std::size_t last = work_.size() - 1; last > 0; --last)
    for (std::size_t i = 0; i < last; ++i)
      for (std::size_t axis = 0; axis < axes_; ++axis)
        work_[i][axis] = (1 - t) * work_[i][axis] + t * work_[i + 1][axis];
  return affine(work_.front());
}

Scaled affine(const Lifted& point) { return over_weight(point); }
bool is_in_hull(const std::vector<Lifted>& control_points) { return weights_have_one_sign(control_points); }

void ScaledCurve::piece(double from, double to, std::vector<Lifted>& control_points) const {
  const std::size_t n = control_points_.size() - 1;
  control_points.clear();
  for (std::size_t j = 0; j <= n; ++j) {
    work_ = control_points_;
    for (std::size_t k = 1; k <= n; ++k) {
      const double t = k <= j ? to : from;
      for (std::size_t i = 0; i + k <= n; ++i)
        for (std::size_t axis = 0; axis < axes_; ++axis)
          work_[i][axis] = (1 - t) * work_[i][axis] + t * work_[i + 1][axis];
    }
    control_points.push_back(work_.front());
  }
}

double distance_to_segment(const Scaled& point, const Scaled& from, const Scaled& to) {
  const auto chord = step_between(to, from);
  auto offset = step_between(point, from);
  const double squared_length = dot_product_of(chord, chord);
  const double along = dot_product_of(offset, chord);
  if (along >= squared_length) {
    offset = step_between(point, to);
  } else if (along > 0) {
    const double part = along / squared_length;
    for (std::size_t axis = 0; axis < 3; ++axis) offset[axis] -= part * chord[axis];
  }
  return std::sqrt(dot_product_of(offset, offset));
}

Enclosure largest_distance(std::vector<Lifted> control_points, const Scaled& from, const Scaled& to, double tolerance,
                           double slack) {
  struct Piece {
    double high;
    int depth;
    std::vector<Lifted> control_points;
  };
  double low = 0;
  const auto piece_of = [&](std::vector<Lifted> b, int depth) {
    const auto distance = [&](const Lifted& point) { return distance_to_segment(affine(point), from, to); };
    double high = is_in_hull(b) ? 0 : std::numeric_limits<double>::infinity();
    for (const auto& point : b) high = std::max(high, distance(point));
    low = std::max({low, distance(b.front()), distance(b.back())});
    return Piece{high, depth, std::move(b)};
  };
  const auto lower = [](const Piece& a, const Piece& b) { return a.high < b.high; };
  constexpr int deepest = 30;
  std::vector<Piece> heap;
  heap.push_back(piece_of(std::move(control_points), 0));
  for (;;) {
    const double high = heap.front().high;
    const double width = high - low;
    const bool decided = high + slack <= tolerance || low - slack > tolerance || width <= slack;
    if ((decided && width <= std::max(high * 0x1p-10, slack)) || heap.front().depth == deepest)
      return {std::max(low - slack, 0.0), high + slack};
    std::ranges::pop_heap(heap, lower);
    Piece piece = std::move(heap.back());
    heap.pop_back();
    std::vector<Lifted> right;
    halve_piece(piece.control_points, right);
    heap.push_back(piece_of(std::move(piece.control_points), piece.depth + 1));
    std::ranges::push_heap(heap, lower);
    heap.push_back(piece_of(std::move(right), piece.depth + 1));
    std::ranges::push_heap(heap, lower);
  }
}

ChordJudgement judge_chord(const ScaledCurve& curve, double t_from, double t_to, std::span<const double> from,
                           std::span<const double> to, double tolerance) {
  std::vector<Lifted> piece;
  curve.piece(t_from, t_to, piece);
  const auto start = curve.scaled(from);
  const auto end = curve.scaled(to);
  const double limit = curve.scaled(tolerance);
  const double apart = std::max(distance_to_segment(affine(piece.front()), start, start),
                                distance_to_segment(affine(piece.back()), end, end)) +
                       curve.slack();
  auto distance = largest_distance(std::move(piece), start, end, limit, curve.slack());
  distance.high = std::max(distance.high, apart);
  const Kept kept = distance.high <= limit      ? Kept::proved
                    : distance.low > limit      ? Kept::refuted
                    : std::isinf(curve.slack()) ? Kept::undecided
                                                : judge_exactly(curve.given(), t_from, t_to, from, to, tolerance);
  return {{curve.unscaled(distance.low), curve.unscaled(distance.high)}, kept};
}

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
