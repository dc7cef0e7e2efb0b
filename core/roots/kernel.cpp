// SPDX-License-Identifier: MIT
#include "core/roots/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/powers.hpp"
#include "core/roots/roster.hpp"

namespace bezierbench {
namespace {

/// The coefficients of the coordinate minus the value, times the power of two that brings the largest of all these
/// numbers into [1/2, 1): no binomial then makes them overflow.
std::vector<double> differences(const CurveView<double>& curve, int axis, double value) {
  double largest = std::abs(value);
  for (int i = 0; i <= curve.degree; ++i) largest = std::max(largest, std::abs(curve(axis, i)));
  const int exponent = binary_exponent(largest);
  std::vector<double> b;
  for (int i = 0; i <= curve.degree; ++i) {
    const double x = curve(axis, i);
    b.push_back(times_power_of_two(x, -exponent) - times_power_of_two(value, -exponent));
    if (b.back() == 0 && x != value) b.back() = std::copysign(std::numeric_limits<double>::denorm_min(), x - value);
  }
  return b;
}

template <RootsMethod M>
FoundRoots find_roots(const CurveView<double>& curve, int axis, double value) {
  return M::find(differences(curve, axis, value));
}

template <class... Methods>
constexpr auto kernels_of_roster(TypeList<Methods...> /*roster*/) {
  return std::array{RootsKernel{&Methods::info, find_roots<Methods>}...};
}

}  // namespace

std::span<const RootsKernel> roots_kernels() {
  static constexpr auto kernels = kernels_of_roster(RootsMethods{});
  return kernels;
}

}  // namespace bezierbench
