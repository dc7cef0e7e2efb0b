// SPDX-License-Identifier: MIT
#include "reference/companion/bspline_control_points.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "reference/rational.hpp"
#include "reference/stop.hpp"

namespace bezierbench::reference {

namespace {

/// A number for each axis; of a rational curve numerators, and then the weight.
using Homogeneous = std::vector<mpq_class>;

struct ExactBspline {
  std::size_t n;
  std::vector<double> knots;
  std::vector<Homogeneous> points;

  [[nodiscard]] double begin() const { return knots[n]; }
  [[nodiscard]] double end() const { return knots[points.size()]; }
};

Rational rational(const mpq_class& x) { return {x.get_num(), x.get_den(), 0}; }

/// Adds `factor` times a point.
void add_multiple(Homogeneous& sum, const mpq_class& factor, const Homogeneous& point) {
  if (sum.empty()) sum.resize(point.size());
  for (std::size_t axis = 0; axis < sum.size(); ++axis) sum[axis] += factor * point[axis];
}

/// The first of the n + 1 knots up to `begin`, and the end of the n + 1 knots from `end` on.
std::pair<std::size_t, std::size_t> range_about(const std::vector<double>& knots, std::size_t n, double begin,
                                                double end) {
  return {static_cast<std::size_t>(std::ranges::upper_bound(knots, begin) - knots.begin()) - n - 1,
          static_cast<std::size_t>(std::ranges::lower_bound(knots, end) - knots.begin()) + n + 1};
}

std::vector<double> knots_about(const std::vector<double>& knots, std::size_t n, double begin, double end) {
  const auto [first, last] = range_about(knots, n, begin, end);
  const auto range = std::span(knots).subspan(first, last - first);
  return {range.begin(), range.end()};
}

/// The curve without control points that have no influence.
ExactBspline exact_bspline(const BsplineCurve& curve) {
  const auto n = static_cast<std::size_t>(curve.degree);
  const auto d = static_cast<std::size_t>(curve.dimension);
  ExactBspline result{n, {}, {}};
  const auto [first, last] = range_about(curve.knots, n, curve.begin(), curve.end());
  for (std::size_t i = first; i < last - n - 1; ++i) {
    if (curve.knots[i] == curve.knots[i + n + 1]) continue;
    result.knots.push_back(curve.knots[i]);
    const mpq_class w = curve.weights.empty() ? 1 : require_finite(curve.weights[i]);
    auto& point = result.points.emplace_back();
    for (std::size_t axis = 0; axis < d; ++axis)
      point.push_back(w * mpq_class(require_finite(curve.control_points[i * d + axis])));
    if (!curve.weights.empty()) point.push_back(w);
  }
  result.knots.insert(result.knots.end(), curve.knots.begin() + static_cast<std::ptrdiff_t>(last - n - 1),
                      curve.knots.begin() + static_cast<std::ptrdiff_t>(last));
  return result;
}

/// The blossom of the piece over the span that begins with knot number `first`.
Homogeneous blossom_in(const ExactBspline& curve, std::size_t first, std::span<const double> arguments) {
  const ExactBsplineWeights weights(std::span(curve.knots).subspan(first - curve.n + 1, 2 * curve.n), arguments);
  Homogeneous sum;
  for (std::size_t j = 0; j <= curve.n; ++j) add_multiple(sum, weights.values()[j], curve.points[first - curve.n + j]);
  return sum;
}

/// The mean of the blossom over `arguments`, n + 1 of them in ascending order, without one of them.
Homogeneous elevated_blossom(const ExactBspline& curve, std::size_t first, std::span<const double> arguments) {
  Homogeneous sum;
  for (std::size_t k = 0; k < arguments.size();) {
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(arguments, arguments[k]) - arguments.begin());
    std::vector<double> others(arguments.begin(), arguments.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    add_multiple(sum, next - k, blossom_in(curve, first, others));
    k = next;
  }
  for (auto& number : sum) number /= arguments.size();
  return sum;
}

/// The curve over `knots`, in its degree or the next one. Its own knots between those of the result's ends are among
/// them, and the result has no control point without influence.
ExactBspline over_knots(const ExactBspline& curve, std::size_t degree, std::vector<double> knots) {
  ExactBspline result{degree, std::move(knots), {}};
  const auto& v = result.knots;
  for (std::size_t i = 0; i + degree + 1 < v.size(); ++i) {
    const double begin = v[std::max(i, degree)];  // of the first span that control point i has influence on
    const auto first = static_cast<std::size_t>(std::ranges::upper_bound(curve.knots, begin) - curve.knots.begin()) - 1;
    const auto arguments = std::span(v).subspan(i + 1, degree);
    result.points.push_back(degree == curve.n ? blossom_in(curve, first, arguments)
                                              : elevated_blossom(curve, first, arguments));
  }
  return result;
}

ExactBspline one_degree_higher(const ExactBspline& curve) {
  std::vector<double> knots;
  for (auto knot = curve.knots.begin(); knot != curve.knots.end(); ++knot) {
    if (knot == curve.knots.begin() || *knot != *(knot - 1)) knots.push_back(*knot);
    knots.push_back(*knot);
  }
  return over_knots(curve, curve.n + 1, knots_about(knots, curve.n + 1, curve.begin(), curve.end()));
}

ExactBspline differentiated(const ExactBspline& curve) {
  ExactBspline result{curve.n - 1, {}, {}};
  const auto& u = curve.knots;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const mpq_class width = mpq_class(u[i + curve.n + 1]) - mpq_class(u[i + 1]);
    if (width == 0) continue;  // a jump: there is no such control point, and a knot less
    const mpq_class factor = mpq_class(curve.n) / width;
    auto& point = result.points.emplace_back();
    add_multiple(point, factor, curve.points[i + 1]);
    add_multiple(point, -factor, curve.points[i]);
    result.knots.push_back(u[i + 1]);
  }
  result.knots.insert(result.knots.end(), u.begin() + static_cast<std::ptrdiff_t>(curve.points.size()), u.end() - 1);
  return result;
}

/// The curve without the last knot at u, between its ends.
ExactBspline without_knot(const ExactBspline& curve, double u) {
  const auto [low, high] = std::equal_range(curve.knots.begin(), curve.knots.end(), u);
  assert(low != high && u > curve.begin() && u < curve.end());
  const std::size_t n = curve.n;
  const auto left = static_cast<std::size_t>(low - curve.knots.begin()) - 1;    // the span before u
  const auto right = static_cast<std::size_t>(high - curve.knots.begin()) - 1;  // the span behind it, and the knot
  ExactBspline result{n, curve.knots, {}};
  result.knots.erase(result.knots.begin() + static_cast<std::ptrdiff_t>(right));
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const auto arguments = std::span(result.knots).subspan(i + 1, n);
    if (i + n < right)
      result.points.push_back(curve.points[i]);
    else if (i >= left)
      result.points.push_back(curve.points[i + 1]);
    else
      result.points.push_back(blossom_in(curve, 2 * i < right - n - 1 + left ? left : right, arguments));
  }
  return result;
}

/// The length of the vector of the first numbers, at most 2^-64 of it more.
mpq_class length_upwards(const Homogeneous& vector, std::size_t dimension) {
  mpq_class squared = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) squared += vector[axis] * vector[axis];
  const mpz_class radicand = (squared.get_num() * squared.get_den()) << 128;
  mpz_class root = sqrt(radicand);
  if (root * root < radicand) ++root;
  mpq_class result(root, squared.get_den() << 64);
  result.canonicalize();
  return result;
}

/// The diagonal of a box of control points, rounded upwards.
mpq_class diagonal(const std::vector<Homogeneous>& points, std::size_t dimension) {
  Homogeneous edges;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const auto coordinate = [&](const Homogeneous& point) {
      return point.size() > dimension ? mpq_class(point[axis] / point.back()) : point[axis];
    };
    const auto [low, high] = std::ranges::minmax(points, {}, coordinate);
    edges.emplace_back(coordinate(high) - coordinate(low));
  }
  return length_upwards(edges, dimension);
}

/// How far the points of `other` are at most from those of `curve` at the same t: two curves over the same knots.
///
/// With numerators A, A' and weights w, w' of the two, C = A / w, and sum (A_i - w_i C) N_i = 0 at every t,
///   C' - C = sum (A'_i - w'_i C) N_i / w' = sum (A'_i - w'_i d_i + (w'_i - w_i) (d_i - C)) N_i / w',
/// where |d_i - C| is at most the diagonal of a box of all control points. For polynomial curves it is |d'_i - d_i|.
mpq_class largest_deviation(const ExactBspline& curve, const ExactBspline& other, std::size_t dimension) {
  const bool is_rational = curve.points.front().size() > dimension;
  mpq_class least_weight = 1;
  mpq_class across = 0;
  if (is_rational) {
    least_weight = other.points.front().back();
    for (const auto& point : other.points) least_weight = std::min(least_weight, point.back());
    across = diagonal(curve.points, dimension);
  }
  mpq_class largest = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    Homogeneous difference;
    add_multiple(difference, 1, other.points[i]);
    mpq_class distance = 0;
    if (is_rational) {
      distance = across * abs(other.points[i].back() - curve.points[i].back());
      add_multiple(difference, -other.points[i].back() / curve.points[i].back(), curve.points[i]);
    } else {
      add_multiple(difference, -1, curve.points[i]);
    }
    distance += length_upwards(difference, dimension);
    largest = std::max(largest, distance);
  }
  return largest / least_weight;
}

/// The least double that is not below x.
double rounded_up(const mpq_class& x) {
  const double nearest = round_to(binary64, rational(x));
  const bool below = std::isfinite(nearest) && mpq_class(nearest) < x;
  return below ? std::nextafter(nearest, std::numeric_limits<double>::infinity()) : nearest;
}

bool has_positive_weights(const ExactBspline& curve, int dimension) {
  return std::ranges::all_of(curve.points, [dimension](const Homogeneous& point) {
    return point.size() == static_cast<std::size_t>(dimension) || round_to(binary64, rational(point.back())) > 0;
  });
}

std::optional<BsplineCurve> rounded_bspline(const ExactBspline& curve, int dimension) {
  if (!has_positive_weights(curve, dimension)) return std::nullopt;
  BsplineCurve result{dimension, static_cast<int>(curve.n), curve.knots, {}, {}};
  for (const auto& point : curve.points) {
    const bool is_rational = point.size() > static_cast<std::size_t>(dimension);
    const Rational w = is_rational ? rational(point.back()) : exactly(1);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      result.control_points.push_back(quotient(binary64, rational(point[axis]), w));
    if (is_rational) result.weights.push_back(round_to(binary64, w));
  }
  return result;
}

}  // namespace

std::optional<BsplineCurve> with_knots_inserted(const BsplineCurve& curve, std::span<const double> knots) {
  const auto exact = exact_bspline(curve);
  auto all = exact.knots;
  all.insert(all.end(), knots.begin(), knots.end());
  std::ranges::sort(all);
  return rounded_bspline(over_knots(exact, exact.n, knots_about(all, exact.n, exact.begin(), exact.end())),
                         curve.dimension);
}

std::optional<BsplineCurve> part_of_bspline(const BsplineCurve& curve, double from, double to) {
  const auto exact = exact_bspline(curve);
  std::vector<double> knots(exact.n + 1, from);
  knots.insert(knots.end(), std::ranges::upper_bound(exact.knots, from), std::ranges::lower_bound(exact.knots, to));
  knots.insert(knots.end(), exact.n + 1, to);
  return rounded_bspline(over_knots(exact, exact.n, std::move(knots)), curve.dimension);
}

std::optional<BsplineCurve> elevated_bspline(const BsplineCurve& curve, int degree) {
  auto exact = exact_bspline(curve);
  while (exact.n < static_cast<std::size_t>(degree)) exact = one_degree_higher(exact);
  return rounded_bspline(exact, curve.dimension);
}

BsplineCurve derivative_of_bspline(const BsplineCurve& curve, int order) {
  assert(curve.weights.empty() && order < curve.degree);
  auto exact = exact_bspline(curve);
  for (int k = 0; k < order; ++k) exact = differentiated(exact);
  return *rounded_bspline(exact, curve.dimension);
}

std::optional<KnotRemoval> with_knots_removed(const BsplineCurve& curve, std::span<const double> knots) {
  const auto given = exact_bspline(curve);
  auto exact = given;
  const auto dimension = static_cast<std::size_t>(curve.dimension);
  mpq_class deviation = 0;
  for (const double knot : knots) {
    auto less = without_knot(exact, knot);
    if (!has_positive_weights(less, curve.dimension)) return std::nullopt;
    deviation += largest_deviation(exact, over_knots(less, less.n, exact.knots), dimension);
    exact = std::move(less);
  }
  auto result = *rounded_bspline(exact, curve.dimension);
  if (deviation == 0) return KnotRemoval{std::move(result), 0};
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(result.control_points, is_finite) || !std::ranges::all_of(result.weights, is_finite))
    return KnotRemoval{std::move(result), std::numeric_limits<double>::infinity()};
  const auto rounded = exact_bspline(result);
  deviation += largest_deviation(exact, rounded, dimension);
  auto both = given.points;
  both.insert(both.end(), rounded.points.begin(), rounded.points.end());
  return KnotRemoval{std::move(result), rounded_up(std::min(deviation, diagonal(both, dimension)))};
}

ExactBsplineWeights::ExactBsplineWeights(std::span<const double> knots, std::span<const double> arguments)
    : weights_(arguments.size() + 1) {
  const std::size_t m = arguments.size();
  assert(knots.size() == 2 * m);
  std::vector<mpq_class> u;
  for (const double knot : knots) u.emplace_back(require_finite(knot));
  weights_[0] = 1;
  for (std::size_t r = 1; r <= m; ++r) {
    const mpq_class x = require_finite(arguments[r - 1]);
    mpq_class carried = 0;
    for (std::size_t i = 0; i < r; ++i) {
      StopWhen::poll();
      const mpq_class& left = u[m - r + i];
      const mpq_class& right = u[m + i];
      const mpq_class share = weights_[i] / (right - left);
      weights_[i] = carried + (right - x) * share;
      carried = (x - left) * share;
    }
    weights_[r] = carried;
  }
}

ExactBsplineWeights ExactBsplineWeights::at(std::span<const double> knots, double t) {
  return {knots, std::vector<double>(knots.size() / 2, t)};
}

ExactBsplineWeights ExactBsplineWeights::of_control_point(std::span<const double> knots, int k) {
  const std::size_t m = knots.size() / 2;
  std::vector<double> arguments(m, knots[m - 1]);
  for (std::size_t i = m - static_cast<std::size_t>(k); i < m; ++i) arguments[i] = knots[m];
  return {knots, arguments};
}

ExactBsplineWeights ExactBsplineWeights::with(std::span<const double> weights) const {
  assert(weights.size() == weights_.size());
  auto result = *this;
  mpq_class total = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    result.weights_[i] *= mpq_class(require_finite(weights[i]));
    total += result.weights_[i];
  }
  for (auto& weight : result.weights_) weight /= total;
  return result;
}

ExactPoint ExactBsplineWeights::sum(int dimension, std::span<const double> control_points) const {
  const auto d = static_cast<std::size_t>(dimension);
  assert(dimension <= max_dimension && control_points.size() == weights_.size() * d);
  std::vector<mpq_class> sums(d);
  for (std::size_t i = 0; i < weights_.size(); ++i)
    for (std::size_t axis = 0; axis < d; ++axis)
      sums[axis] += weights_[i] * mpq_class(require_finite(control_points[i * d + axis]));
  ExactPoint point;
  point.dimension = dimension;
  for (const auto& sum : sums)
    mpz_lcm(point.denominator.get_mpz_t(), point.denominator.get_mpz_t(), sum.get_den_mpz_t());
  for (std::size_t axis = 0; axis < d; ++axis)
    point.numerator[axis] = sums[axis].get_num() * (point.denominator / sums[axis].get_den());
  return point;
}

}  // namespace bezierbench::reference
