// SPDX-License-Identifier: MIT
// What callers hand in as a curve: a contiguous range of std::array<Scalar, d>, such as std::vector<std::array<double,
// 2>>. The number of points is known at compile time where the type says it (std::array, a fixed std::span, an array
// of C).
#pragma once

#include <array>
#include <cstddef>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "core/curve_view.hpp"

namespace bezierbench {

namespace detail {

template <class T>
inline constexpr std::size_t array_size = 0;
template <class Scalar, std::size_t Size>
inline constexpr std::size_t array_size<std::array<Scalar, Size>> = Size;

}  // namespace detail

/// A contiguous range of std::array<Scalar, d> with d >= 1: control points or coefficients, ascending.
template <class Points>
concept ControlPoints = std::ranges::contiguous_range<const Points> && std::ranges::sized_range<const Points> &&
    (detail::array_size<std::remove_cv_t<std::ranges::range_value_t<const Points>>> > 0);

/// std::array<Scalar, d>.
template <ControlPoints Points>
using PointOf = std::remove_cv_t<std::ranges::range_value_t<const Points>>;

/// The type of a coordinate.
template <ControlPoints Points>
using ScalarOf = typename PointOf<Points>::value_type;

/// Points in double or float, the types that errors and bounds are defined for.
template <class Points>
concept MeasuredPoints = ControlPoints<Points> &&
    (std::is_same_v<ScalarOf<Points>, double> || std::is_same_v<ScalarOf<Points>, float>);

/// The weights of a rational curve, one for each of its control points.
template <class Weights, class Points>
concept WeightsOf =
    ControlPoints<Points> && std::ranges::contiguous_range<const Weights> && std::ranges::sized_range<const Weights> &&
    std::is_same_v<std::remove_cv_t<std::ranges::range_value_t<const Weights>>, ScalarOf<Points>>;

/// The number of points that the type says, or std::dynamic_extent.
template <ControlPoints Points>
inline constexpr std::size_t fixed_count = decltype(std::span(std::declval<const Points&>()))::extent;

/// The degree of the curve with these points. Throws std::invalid_argument unless it is within `lowest` .. `highest`.
template <ControlPoints Points>
int degree_of_points(const Points& points, int lowest = 0, int highest = max_degree) {
  const auto count = static_cast<std::size_t>(std::ranges::size(points));
  if (count == 0) throw std::invalid_argument("bezierbench: a curve has at least one point");
  if (count < static_cast<std::size_t>(lowest) + 1 || count > static_cast<std::size_t>(highest) + 1)
    throw std::invalid_argument("bezierbench: degree " + std::to_string(count - 1) + " is outside " +
                                std::to_string(lowest) + " .. " + std::to_string(highest));
  return static_cast<int>(count) - 1;
}

/// Throws std::invalid_argument unless there is a weight for each point.
template <ControlPoints Points, WeightsOf<Points> Weights>
void require_weights(const Points& points, const Weights& weights) {
  if (std::ranges::size(weights) != std::ranges::size(points))
    throw std::invalid_argument("bezierbench: " + std::to_string(std::ranges::size(points)) + " points and " +
                                std::to_string(std::ranges::size(weights)) + " weights");
}

}  // namespace bezierbench
