// SPDX-License-Identifier: MIT
#include "core/interpolate/spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/interpolate/kernel.hpp"
#include "core/powers.hpp"

namespace bezierbench {

namespace {

/// left m_(i-1) + centre m_i + right m_(i+1) = value.
struct Row {
  double left;
  double centre;
  double right;
  double value;
};

/// One axis, scaled by a power of two.
struct Axis {
  std::vector<double> coordinates;  ///< of a closed spline the first once more
  int exponent = 0;
  double start = 0;  ///< derivatives of clamped ends
  double end = 0;
};

Axis axis_of(std::span<const double> points, int dimension, int axis, const SplineConditions& conditions) {
  const auto d = static_cast<std::size_t>(dimension);
  const auto a = static_cast<std::size_t>(axis);
  const bool clamped = !conditions.closed && conditions.ends == SplineEnds::clamped;
  Axis result;
  double largest = 0;
  for (std::size_t k = a; k < points.size(); k += d) largest = std::max(largest, std::abs(points[k]));
  if (clamped)
    largest = std::max({largest, std::abs(conditions.start_derivative[a]), std::abs(conditions.end_derivative[a])});
  result.exponent = binary_exponent(largest);
  for (std::size_t k = a; k < points.size(); k += d)
    result.coordinates.push_back(std::ldexp(points[k], -result.exponent));
  if (conditions.closed) result.coordinates.push_back(result.coordinates.front());
  if (clamped) {
    result.start = std::ldexp(conditions.start_derivative[a], -result.exponent);
    result.end = std::ldexp(conditions.end_derivative[a], -result.exponent);
  }
  return result;
}

/// The row of a knot between segments with the steps g and h and the chords r and s.
Row inner_row(double g, double h, double r, double s) {
  const double left = h / (g + h);
  const double right = g / (g + h);
  return {left, 2, right, 3 * (left * r + right * s)};
}

/// The row of the beginning, with the steps and chords of the first two segments; the end is its mirror image.
/// `derivative` is that of a clamped end.
Row end_row(SplineEnds ends, double derivative, std::span<const double> steps, std::span<const double> chords) {
  const std::size_t n = steps.size();
  if (ends == SplineEnds::clamped) return {0, 1, 0, derivative / steps[0]};
  if (ends == SplineEnds::natural || n == 1) return {0, 2, 1, 3 * chords[0]};
  if (n == 2) return {0, 1, 1, 2 * chords[0]};
  const double first = steps[0] / (steps[0] + steps[1]);
  const double second = steps[1] / (steps[0] + steps[1]);
  return {0, second, 1, (2 + first) * second * chords[0] + first * first * chords[1]};
}

std::vector<double> reversed(std::span<const double> values) { return {values.rbegin(), values.rend()}; }

std::vector<Row> rows_of(const Axis& axis, std::span<const double> h, std::span<const double> s,
                         const SplineConditions& conditions) {
  const std::size_t n = h.size();
  std::vector<Row> rows;
  rows.push_back(conditions.closed ? inner_row(h[n - 1], h[0], s[n - 1], s[0])
                                   : end_row(conditions.ends, axis.start, h, s));
  for (std::size_t i = 1; i < n; ++i) rows.push_back(inner_row(h[i - 1], h[i], s[i - 1], s[i]));
  if (conditions.closed) return rows;
  rows.push_back(end_row(conditions.ends, axis.end, reversed(h), reversed(s)));
  std::swap(rows.back().left, rows.back().right);
  return rows;
}

/// Solves tridiagonal rows by elimination without pivoting.
std::vector<double> solved(std::vector<Row> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[i];
    if (i > 0) {
      row.centre -= row.left * rows[i - 1].right;
      row.value -= row.left * rows[i - 1].value;
    }
    row.right /= row.centre;
    row.value /= row.centre;
  }
  std::vector<double> x(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;)
    x[i] = rows[i].value - (i + 1 < rows.size() ? rows[i].right * x[i + 1] : 0);
  return x;
}

/// Solves rows the first and last of which are neighbours: all but row 0 depending on m_0, which row 0 then gives.
std::vector<double> solved_cyclic(const std::vector<Row>& rows) {
  std::vector<Row> inner(rows.begin() + 1, rows.end());
  const auto values = solved(inner);  // for m_0 = 0; the coefficients of m_0 are unused
  for (Row& row : inner) row.value = 0;
  inner.front().value -= inner.front().left;
  inner.back().value -= inner.back().right;
  const auto weights = solved(inner);  // of m_0
  const Row& row = rows.front();
  std::vector<double> x{(row.value - row.left * values.back() - row.right * values.front()) /
                        (row.centre + row.left * weights.back() + row.right * weights.front())};
  for (std::size_t i = 0; i < values.size(); ++i) x.push_back(values[i] + weights[i] * x[0]);
  return x;
}

/// A slope within 0 ... 3 r and 0 ... 3 s, the nearest to `slope`.
double limited(double slope, double r, double s) {
  if (!(r > 0 && s > 0) && !(r < 0 && s < 0)) return 0;
  const double most = 3 * std::min(std::abs(r), std::abs(s));
  return r > 0 ? std::clamp(slope, 0.0, most) : std::clamp(slope, -most, 0.0);
}

/// The slopes at all knots; those of a closed spline end with the first.
std::vector<double> slopes_of(const Axis& axis, std::span<const double> h, const SplineConditions& conditions) {
  const std::size_t n = h.size();
  std::vector<double> chords(n);
  for (std::size_t i = 0; i < n; ++i) chords[i] = (axis.coordinates[i + 1] - axis.coordinates[i]) / h[i];
  const auto rows = rows_of(axis, h, chords, conditions);
  auto slopes = conditions.closed ? solved_cyclic(rows) : solved(rows);
  if (conditions.closed) slopes.push_back(slopes.front());
  if (!conditions.monotone) return slopes;
  const double before = conditions.closed ? chords[n - 1] : chords[0];
  const double after = conditions.closed ? chords[0] : chords[n - 1];
  for (std::size_t i = 0; i <= n; ++i)
    slopes[i] = limited(slopes[i], i > 0 ? chords[i - 1] : before, i < n ? chords[i] : after);
  return slopes;
}

}  // namespace

std::vector<double> spline_segments(std::span<const double> points, int dimension, std::span<const double> steps,
                                    const SplineConditions& conditions) {
  const bool uniform = std::ranges::all_of(steps, [](double step) { return step == 1; });
  if (uniform && conditions.ends == SplineEnds::natural && !conditions.closed && !conditions.monotone)
    return interpolation_kernels().front().interpolate(points, dimension);
  const auto d = static_cast<std::size_t>(dimension);
  const std::size_t count = points.size() / d;
  std::vector<double> segments(4 * steps.size() * d);
  for (int axis = 0; axis < dimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Axis scaled = axis_of(points, dimension, axis, conditions);
    const auto& k = scaled.coordinates;
    const auto slopes = slopes_of(scaled, steps, conditions);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      double first = k[i] + steps[i] * slopes[i] / 3;
      double second = k[i + 1] - steps[i] * slopes[i + 1] / 3;
      if (conditions.monotone) {  // rounding must not move them out of the range where a cubic is monotone
        const auto [low, high] = std::minmax(k[i], k[i + 1]);
        first = std::clamp(first, low, high);
        second = std::clamp(second, low, high);
      }
      double* segment = segments.data() + 4 * i * d + a;
      segment[0] = points[i * d + a];
      segment[d] = std::ldexp(first, scaled.exponent);
      segment[2 * d] = std::ldexp(second, scaled.exponent);
      segment[3 * d] = points[(i + 1) % count * d + a];
    }
  }
  return segments;
}

namespace {

/// significand * 2^exponent, since a distance may be beyond the doubles.
struct Length {
  double significand = 0;
  int exponent = 0;
};

Length distance(const double* a, const double* b, std::size_t dimension) {
  double largest = 0;
  for (std::size_t k = 0; k < dimension; ++k) largest = std::max(largest, std::abs(b[k] / 2 - a[k] / 2));
  // halves of neighbouring subnormal numbers may agree
  const bool small = largest < 0x1p-1000;
  if (small)
    for (std::size_t k = 0; k < dimension; ++k) largest = std::max(largest, std::abs(b[k] - a[k]));
  if (largest == 0) return {};
  Length length;
  length.exponent = binary_exponent(largest);
  double square = 0;
  for (std::size_t k = 0; k < dimension; ++k) {
    const double part = std::ldexp(small ? b[k] - a[k] : b[k] / 2 - a[k] / 2, -length.exponent);
    square += part * part;
  }
  length.significand = std::sqrt(square);
  if (!small) ++length.exponent;
  return length;
}

Length root(Length length) {
  if (length.exponent % 2 != 0) {
    length.significand *= 2;
    --length.exponent;
  }
  return {std::sqrt(length.significand), length.exponent / 2};
}

}  // namespace

std::vector<double> knot_steps(std::span<const double> points, int dimension, Parameters parameters, bool closed) {
  constexpr int min_exponent = -900;  // below that, slopes would overflow
  const auto d = static_cast<std::size_t>(dimension);
  const std::size_t count = points.size() / d;
  std::vector<double> steps(closed ? count : count - 1, 1);
  if (parameters == Parameters::uniform) return steps;
  std::vector<Length> lengths;
  int largest = std::numeric_limits<int>::min();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    auto length = distance(&points[i * d], &points[(i + 1) % count * d], d);
    if (parameters == Parameters::centripetal) length = root(length);
    if (length.significand > 0) {
      int exponent = 0;
      length.significand = std::frexp(length.significand, &exponent);
      length.exponent += exponent;
      largest = std::max(largest, length.exponent);
    }
    lengths.push_back(length);
  }
  double unit = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto [significand, exponent] = lengths[i];
    steps[i] = significand == 0 || exponent < largest + min_exponent ? 0 : std::ldexp(significand, exponent - largest);
    unit = std::max(unit, steps[i]);
  }
  if (unit > 0)
    for (double& step : steps) step /= unit;
  return steps;
}

}  // namespace bezierbench
