// SPDX-License-Identifier: MIT
// What libbezierbench.so computes exactly of a curve and rounds once, for ranges: parts, curves in a higher degree, and roots,
// extrema and inflections with their multiplicities.
#pragma once

#include <bezierbench/bezierbench.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <ranges>
#include <span>
#include <stdexcept>
#include <vector>

namespace bezierbench {

/// Control points, not premultiplied, and one weight for each of a rational curve.
template <std::size_t d>
struct RoundedCurve {
  std::vector<std::array<double, d>> points;
  std::vector<double> weights;
};

/// A parameter in [0, 1], rounded once; an odd multiplicity changes the sign.
struct RootOfCurve {
  double t;
  int multiplicity;
};

namespace detail {

template <class T>
inline constexpr std::size_t axes_of_point = 0;
template <std::size_t d>
inline constexpr std::size_t axes_of_point<std::array<double, d>> = d;

inline void throw_unless_ok(int status) {
  if (status == BB_ERROR_MEMORY) throw std::bad_alloc();
  if (status != BB_OK) throw std::invalid_argument(bb_strerror(status));
}

}  // namespace detail

/// A contiguous range of std::array<double, d>.
template <class Range>
concept DoublePoints = std::ranges::contiguous_range<Range> && std::ranges::sized_range<Range> &&
    (detail::axes_of_point<std::ranges::range_value_t<Range>> > 0);

template <DoublePoints Points>
inline constexpr std::size_t axes_of = detail::axes_of_point<std::ranges::range_value_t<Points>>;

namespace detail {

template <DoublePoints Points>
bb_curve curve_in_c(const Points& points, std::span<const double> weights) {
  const std::size_t count = std::ranges::size(points);
  if (count == 0) throw std::invalid_argument("bezierbench: there are no control points");
  if (!weights.empty() && weights.size() != count)
    throw std::invalid_argument("bezierbench: there must be as many weights as control points");
  return {weights.empty() ? BB_BERNSTEIN : BB_RATIONAL, static_cast<int>(axes_of<Points>), static_cast<int>(count) - 1,
          std::ranges::data(points)->data(), weights.empty() ? nullptr : weights.data()};
}

template <DoublePoints Points, class Call>
RoundedCurve<axes_of<Points>> rounded_curve(int degree, bool rational, const Call& call) {
  RoundedCurve<axes_of<Points>> result;
  result.points.resize(static_cast<std::size_t>(degree) + 1);
  result.weights.resize(rational ? result.points.size() : 0);
  const bb_half to{result.points.front().data(), rational ? result.weights.data() : nullptr};
  throw_unless_ok(call(&to));
  return result;
}

template <DoublePoints Points>
std::vector<RootOfCurve> roots_in_c(const Points& points, std::span<const double> weights, bb_roots_of of, int axis,
                                    double value) {
  const bb_curve curve = curve_in_c(points, weights);
  std::vector<double> t(3 * std::ranges::size(points));
  std::vector<int> multiplicities(t.size());
  std::size_t count = 0;
  throw_unless_ok(bb_roots(&curve, of, axis, value, t.data(), multiplicities.data(), t.size(), &count));
  if (count == SIZE_MAX) throw std::invalid_argument("bezierbench: every parameter is a root");
  std::vector<RootOfCurve> roots;
  for (std::size_t k = 0; k < count; ++k) roots.push_back({t[k], multiplicities[k]});
  return roots;
}

}  // namespace detail

// All throw std::invalid_argument for what the library refuses, such as a pole in [0, 1] or more than 3 axes (5 of parts and
// of curves in a higher degree).

/// The curve over t in [from, to], which may lie outside [0, 1] and may fall; see bb_part.
template <DoublePoints Points>
RoundedCurve<axes_of<Points>> part(const Points& points, double from, double to, std::span<const double> weights = {}) {
  const bb_curve curve = detail::curve_in_c(points, weights);
  return detail::rounded_curve<Points>(curve.degree, !weights.empty(),
                                       [&](const bb_half* half) { return bb_part(&curve, from, to, half); });
}

/// The same curve in a degree from its own to 1023.
template <DoublePoints Points>
RoundedCurve<axes_of<Points>> elevate(const Points& points, int degree, std::span<const double> weights = {}) {
  const bb_curve curve = detail::curve_in_c(points, weights);
  if (degree < curve.degree || degree > 1023) throw std::invalid_argument(bb_strerror(BB_ERROR_DEGREE));
  return detail::rounded_curve<Points>(degree, !weights.empty(),
                                       [&](const bb_half* half) { return bb_elevate(&curve, degree, half); });
}

/// All t in [0, 1] at which the coordinate is `value`, ascending. Throws, too, where every t is one.
template <DoublePoints Points>
std::vector<RootOfCurve> roots(const Points& points, int axis, double value = 0, std::span<const double> weights = {}) {
  return detail::roots_in_c(points, weights, BB_ROOTS_OF_VALUE, axis, value);
}

/// All t in [0, 1] at which the derivative of the coordinate is 0.
template <DoublePoints Points>
std::vector<RootOfCurve> extrema(const Points& points, int axis, std::span<const double> weights = {}) {
  return detail::roots_in_c(points, weights, BB_ROOTS_OF_DERIVATIVE, axis, 0);
}

/// All t in [0, 1] at which x'y'' = x''y' on a curve in the plane: inflections where the multiplicity is odd and the curve has a
/// tangent.
template <DoublePoints Points>
std::vector<RootOfCurve> inflections(const Points& points, std::span<const double> weights = {}) {
  return detail::roots_in_c(points, weights, BB_ROOTS_OF_CURVATURE, 0, 0);
}

}  // namespace bezierbench
