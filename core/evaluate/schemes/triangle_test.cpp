// SPDX-License-Identifier: MIT
// Schemes that run the steps of a textbook loop in another order, against that loop.
#include "core/evaluate/schemes/triangle.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/evaluate/methods/estrin.hpp"
#include "core/evaluate/schemes/steps.hpp"

namespace bezierbench {
namespace {

/// A scalar that takes four values at once and ends in registers, as the axes of a point do.
struct InTiles {
  double value;
};

}  // namespace

template <>
inline constexpr TriangleOrder triangle_order<InTiles>{.width = 4, .ends_in_registers = true};
template <>
inline constexpr bool writes_out_steps<InTiles> = true;

namespace {

/// Numbers of different magnitudes, whose sums round.
double coefficient(int i) { return ((i * 7919) % 1009 - 504.0) / (1 + i % 7); }

TEST(Triangle, HasTheBitsOfALoopOverItsLevels) {
  const auto step = [](double a, double b) { return 0.7 * a + 0.3 * b; };
  for (int n = 0; n <= 130; ++n) {
    std::vector<double> b;
    for (int i = 0; i <= n; ++i) b.push_back(coefficient(i));
    for (std::size_t count = b.size() - 1; count > 0; --count)
      for (std::size_t i = 0; i < count; ++i) b[i] = step(b[i], b[i + 1]);
    EXPECT_EQ(detail::apex_by_sweeps<double>(n, coefficient, step), b[0]) << n;
    const auto in_tiles = detail::apex_by_sweeps<InTiles>(
        n, [](int i) { return InTiles{coefficient(i)}; },
        [&](InTiles a, InTiles c) { return InTiles{step(a.value, c.value)}; });
    EXPECT_EQ(in_tiles.value, b[0]) << n;
  }
}

TEST(Triangle, WrittenOutForADegreeHasTheSameBits) {
  const auto step = [](double a, double b) { return a + 0.3 * (b - a); };
  EXPECT_EQ((detail::apex_by_levels<double>(coefficient, step, std::make_integer_sequence<int, 7>())),
            detail::apex_by_sweeps<double>(7, coefficient, step));
}

TEST(CountDown, TakesEveryStepOnceInOrder) {
  for (int last = -1; last <= 70; ++last) {
    int next = last;
    count_down<InTiles, dynamic>(last, [&next](int step) { EXPECT_EQ(step, next--); });
    EXPECT_EQ(next, -1);
  }
}

/// Estrin's levels as they are printed: neighbours are joined with t, then pairs with t^2, and so on.
double by_levels(std::vector<double> q, double t) {
  for (double power = t; q.size() > 1; power *= power) {
    std::vector<double> joined;
    for (std::size_t k = 0; k + 1 < q.size(); k += 2) joined.push_back(q[k] + q[k + 1] * power);
    if (q.size() % 2 != 0) joined.push_back(q.back());
    q = joined;
  }
  return q[0];
}

TEST(Estrin, HasTheBitsOfItsLevels) {
  for (int n = 0; n <= 300; ++n) {
    Curve<Form::power, double, 1> curve(n);
    std::vector<double> q;
    for (int j = 0; j <= n; ++j) q.push_back(curve(0, j) = coefficient(j));
    for (const double t : {0.3, 0.97, -1.1})
      EXPECT_EQ(Estrin::evaluate(curve, t)[0], by_levels(q, t)) << "degree " << n << ", t = " << t;
  }
  Curve<Form::power, double, 1> largest(max_degree);
  for (int j = 0; j <= max_degree; ++j) largest(0, j) = 1;
  EXPECT_EQ(Estrin::evaluate(largest, 1.0)[0], max_degree + 1.0);
}

}  // namespace
}  // namespace bezierbench
