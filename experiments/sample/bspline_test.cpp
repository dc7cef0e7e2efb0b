// SPDX-License-Identifier: MIT
#include "experiments/sample/bspline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {
namespace {

Trial drawn(int degree, double range, std::uint64_t trial) {
  Trial out;
  Sampler(1, "spline", {Form::bernstein, 2, degree, range, {}, "bspline"}).draw(trial, out);
  return out;
}

TEST(BsplineGenerator, StaysInItsRange) {
  for (const int degree : {0, 1, 2, 7, 50})
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
      for (const double x : drawn(degree, 3, trial).coefficients) EXPECT_LE(std::abs(x), 3);
      for (const double x : drawn(degree, 0, trial).coefficients) EXPECT_EQ(x, 0);
    }
}

/// Neighbours in the Bernstein form are averages of the same points: sums of differences are smaller than those of
/// random points, whose mean is 2/3 of the range on each axis.
TEST(BsplineGenerator, NeighboursAreCloserThanRandomPoints) {
  double sum = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    const auto b = drawn(5, 1, trial).coefficients;
    for (std::size_t k = 2; k < b.size(); ++k) sum += std::abs(b[k] - b[k - 2]);
  }
  EXPECT_LT(sum / (200 * 10), 0.25);
}

}  // namespace
}  // namespace bezierbench::sample
