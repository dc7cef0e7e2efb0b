// SPDX-License-Identifier: MIT
// The curves of generator `cusp` have their cusp exactly where they should: computed with rationals.
#include "experiments/sample/cusp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <set>
#include <vector>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {
namespace {

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

}  // namespace
}  // namespace bezierbench::sample
