// SPDX-License-Identifier: MIT
#include "reference/companion/chord_distance.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/companion/exact_range.hpp"

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

}  // namespace bezierbench::reference
