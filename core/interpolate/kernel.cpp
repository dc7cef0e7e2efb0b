// SPDX-License-Identifier: MIT
#include "core/interpolate/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/interpolate/roster.hpp"
#include "core/powers.hpp"

namespace bezierbench {
namespace {

/// The coordinates of one axis, scaled.
struct Axis {
  std::vector<double> coordinates;
  int exponent = 0;  ///< the coordinates were divided by 2^exponent
};

Axis scaled_axis(std::span<const double> points, std::size_t dimension, std::size_t axis) {
  Axis result;
  double largest = 0;
  for (std::size_t k = axis; k < points.size(); k += dimension) largest = std::max(largest, std::abs(points[k]));
  result.exponent = binary_exponent(largest);
  for (std::size_t k = axis; k < points.size(); k += dimension)
    result.coordinates.push_back(std::ldexp(points[k], -result.exponent));
  return result;
}

template <InterpolationMethod M>
std::vector<double> interpolate(std::span<const double> points, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  const std::size_t n = points.size() / d - 1;
  std::vector<double> segments(4 * n * d);
  for (std::size_t axis = 0; axis < d; ++axis) {
    const auto [coordinates, exponent] = scaled_axis(points, d, axis);
    const InnerPoints inner = M::inner_points(coordinates);
    for (std::size_t i = 0; i < n; ++i) {
      double* segment = segments.data() + 4 * i * d + axis;
      segment[0] = points[i * d + axis];
      segment[d] = std::ldexp(inner.first[i], exponent);
      segment[2 * d] = std::ldexp(inner.second[i], exponent);
      segment[3 * d] = points[(i + 1) * d + axis];
    }
  }
  return segments;
}

template <class... Methods>
std::span<const InterpolationKernel> kernels_of(TypeList<Methods...> /*roster*/) {
  static constexpr std::array kernels{
      InterpolationKernel{&Methods::info, Methods::residual_bound, interpolate<Methods>}...};
  return kernels;
}

}  // namespace

std::span<const InterpolationKernel> interpolation_kernels() { return kernels_of(InterpolationMethods{}); }

}  // namespace bezierbench
