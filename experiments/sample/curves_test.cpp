// SPDX-License-Identifier: MIT
// Generators of whole curves: bspline, cusp (its cusp is exactly where it should be, computed with rationals) and thin.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "experiments/sample/bspline.hpp"
#include "experiments/sample/cusp.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/sample/thin.hpp"

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

using ExactRational = boost::multiprecision::cpp_rational;

/// C'(t) / n on one axis, by de Casteljau's algorithm.
ExactRational slope(const std::vector<double>& coordinates, std::size_t d, std::size_t axis, const ExactRational& t) {
  std::vector<ExactRational> row;
  for (std::size_t k = axis + d; k < coordinates.size(); k += d)
    row.push_back(ExactRational(coordinates[k]) - ExactRational(coordinates[k - d]));
  for (; row.size() > 1; row.pop_back())
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] += t * (row[i + 1] - row[i]);
  return row.front();
}

TEST(Cusp, StopsExactlyOrNearlyAtEveryDegree) {
  for (int n = 2; n <= Cusp::largest_degree; ++n) {
    std::set<int> places;
    int exact = 0;
    constexpr int trials = 400;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      const double range = trial % 2 == 0 ? 1 : 0x1p-700;
      Trial out;
      draw(1, 2, {Form::bernstein, 3, n, range, {}, "cusp"}, trial, out);
      ExactRational least = 1;
      int place = 0;
      for (int quarters = 1; quarters <= 8; ++quarters) {
        ExactRational most = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
          most = std::max(most,
                          ExactRational(abs(slope(out.coefficients, 3, axis, ExactRational(quarters, quarters + 4)))));
        most /= ExactRational(range);
        if (most < least) place = quarters;
        least = std::min(least, most);
      }
      EXPECT_LE(least, ExactRational(1, 32)) << n << " " << trial;
      places.insert(place);
      exact += least == 0 ? 1 : 0;
      for (const double x : out.coefficients) EXPECT_LE(std::abs(x), range);
    }
    EXPECT_EQ(places.size(), 8U) << n;
    EXPECT_NEAR(exact, trials / 2, 50) << n;  // five standard deviations
  }
}

TEST(Cusp, OfDegreesWithoutAnInsideIsAPoint) {
  Trial out;
  draw(1, 2, {Form::bernstein, 2, 0, 1, {}, "cusp"}, 0, out);
  EXPECT_EQ(out.coefficients.size(), 2U);
  draw(1, 2, {Form::bernstein, 1, 1, 1, {}, "cusp"}, 0, out);
  EXPECT_LE(std::abs(out.coefficients[0] - out.coefficients[1]), 1.0 / 32);
}

TEST(Thin, IsWholeOnTheFirstAxisAndNextToNothingOnOthers) {
  constexpr int trials = 400;
  int zigzags = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    Trial out;
    draw(1, 2, {Form::bernstein, 3, 5, 0x1p-700, {}, "thin"}, trial, out);
    bool zigzag = true;
    for (std::size_t k = 0; k < out.coefficients.size(); ++k) {
      const double x = std::ldexp(out.coefficients[k], 700 + 5);
      if (k % 3 == 0) {
        EXPECT_EQ(x, std::round(x)) << trial;
        EXPECT_LE(std::abs(x), 32) << trial;
        zigzag = zigzag && (k / 3 % 2 == 0 ? x <= 0 : x >= 0);
      } else {
        EXPECT_EQ(std::ldexp(x, 20), std::round(std::ldexp(x, 20))) << trial;
        EXPECT_LE(std::abs(x), 2) << trial;
      }
    }
    zigzags += zigzag ? 1 : 0;
  }
  EXPECT_NEAR(zigzags, trials / 2 + trials / 128, 55);  // one in 64 of the other curves zigzags by chance
}

TEST(Thin, OnOneAxisIsWhole) {
  Trial out;
  draw(1, 2, {Form::bernstein, 1, 40, 32, {}, "thin"}, 7, out);
  for (const double x : out.coefficients) EXPECT_EQ(x, std::round(x));
}

}  // namespace
}  // namespace bezierbench::sample
