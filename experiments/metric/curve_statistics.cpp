// SPDX-License-Identifier: MIT
#include "experiments/metric/curve_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/tally.hpp"

namespace bezierbench::metric {
namespace {

using Point = std::array<double, 3>;

constexpr double straight = 1e-12;

struct Group {
  CurveGroup group;
  std::vector<double> sizes;
  std::vector<double> distances;
};

/// What large coordinates are multiplied by before they are subtracted; the differences of small ones lose nothing.
double scale_of(const CurveView<double>& curve) {
  return std::ranges::any_of(curve.coefficients, [](double x) { return std::abs(x) > 1; }) ? 0.5 : 1;
}

/// Control point i from the first one, in units of the largest extent, so that no square overflows or vanishes.
Point offset_of(const CurveView<double>& curve, int i, double scale, double scaled_size) {
  Point offset{};
  for (int axis = 0; axis < curve.dimension; ++axis)
    offset.at(static_cast<std::size_t>(axis)) = (scale * curve(axis, i) - scale * curve(axis, 0)) / scaled_size;
  return offset;
}

double product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool is_collinear(const CurveView<double>& curve, double scale, double scaled_size) {
  Point direction{};
  for (int i = 1; i <= curve.degree; ++i)
    if (const auto offset = offset_of(curve, i, scale, scaled_size);
        product(offset, offset) > product(direction, direction))
      direction = offset;
  const double length = std::sqrt(product(direction, direction));
  for (auto& x : direction) x /= length;
  for (int i = 1; i <= curve.degree; ++i) {
    auto beside = offset_of(curve, i, scale, scaled_size);
    const double along = product(beside, direction);
    for (std::size_t axis = 0; axis < 3; ++axis) beside.at(axis) -= along * direction.at(axis);
    if (!(product(beside, beside) <= straight * straight)) return false;
  }
  return true;
}

bool same_point(const CurveView<double>& curve, int i, int j) {
  for (int axis = 0; axis < curve.dimension; ++axis)
    if (curve(axis, i) != curve(axis, j)) return false;
  return true;
}

bool is_monotone(const CurveView<double>& curve) {
  for (int axis = 0; axis < curve.dimension; ++axis) {
    bool rises = false;
    bool falls = false;
    for (int i = 1; i <= curve.degree; ++i) {
      rises = rises || curve(axis, i) > curve(axis, i - 1);
      falls = falls || curve(axis, i) < curve(axis, i - 1);
    }
    if (rises && falls) return false;
  }
  return true;
}

void add_shape(const CurveView<double>& curve, Group& to) {
  bool neighbours = false;
  bool point = true;
  for (int i = 1; i <= curve.degree; ++i) {
    const bool same = same_point(curve, i, i - 1);
    neighbours = neighbours || same;
    point = point && same;
  }
  const double scale = scale_of(curve);
  const double scaled_size = size_of(curve, scale);
  to.sizes.push_back(scaled_size / scale);
  if (point) {
    ++to.group.points;
    return;
  }
  double largest = 0;
  for (const double x : curve.coefficients) largest = std::max(largest, std::abs(x));
  to.distances.push_back(scale * largest / scaled_size);
  to.group.coincident_ends += same_point(curve, 0, curve.degree) ? 1 : 0;
  to.group.coincident_neighbours += neighbours ? 1 : 0;
  to.group.collinear += curve.degree > 1 && is_collinear(curve, scale, scaled_size) ? 1 : 0;
  to.group.monotone += is_monotone(curve) ? 1 : 0;
}

CurveQuantiles quantiles_of(std::vector<double>& values) {
  if (values.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  std::ranges::sort(values);
  return {quantile(values, 0.5), quantile(values, 0.99), values.back()};
}

}  // namespace

std::vector<CurveGroup> curve_statistics(const curves::CurveSet& set) {
  std::map<std::tuple<int, Form, int>, Group> groups;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto curve = set[k];
    auto& of = groups[{curve.degree, curve.form, curve.dimension}];
    auto& group = of.group;
    const auto [low, high] = std::ranges::minmax(curve.coefficients);
    const bool first = group.curves++ == 0;
    group.form = curve.form;
    group.dimension = curve.dimension;
    group.degree = curve.degree;
    group.low = first ? low : std::min(group.low, low);
    group.high = first ? high : std::max(group.high, high);
    if (curve.form != Form::power) add_shape(curve, of);
  }
  std::vector<CurveGroup> result;
  for (auto& [key, of] : groups) {
    of.group.size = quantiles_of(of.sizes);
    of.group.distance = quantiles_of(of.distances);
    result.push_back(of.group);
  }
  std::ranges::stable_sort(result, std::greater<>(), &CurveGroup::curves);
  return result;
}

}  // namespace bezierbench::metric
