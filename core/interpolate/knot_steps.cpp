// SPDX-License-Identifier: MIT
#include "core/interpolate/knot_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/powers.hpp"

namespace bezierbench {
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
