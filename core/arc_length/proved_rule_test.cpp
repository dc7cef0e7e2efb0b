// SPDX-License-Identifier: MIT
// A proved rule misses no more than the proof says, compared with the mean speed to 70 digits.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/arc_length/gauss_legendre.hpp"
#include "core/arc_length/gauss_legendre_adaptive.hpp"
#include "core/arc_length/speed.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench {
namespace {

/// Control vectors of a hodograph that all lie within `spread` of the first axis' unit vector.
std::vector<double> about_an_axis(Inputs& inputs, int degree, int dimension, double spread) {
  auto vectors = inputs.coefficients(degree, dimension);
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    vectors[k] *= spread;
    if (k % static_cast<std::size_t>(dimension) == 0) vectors[k] += 1;
  }
  return vectors;
}

/// The number of times that no rule, or that of 8, 16 or 24 points, was proved.
struct Count {
  std::array<int, 4> rules{};
};

template <int Dimension>
void expect_proofs_to_hold(Count& count) {
  Inputs inputs(31);
  for (int trial = 0; trial < 63; ++trial) {
    const int m = trial % 9 == 8 ? 20 : trial % 9;
    const double spread = std::ldexp(1.0, -trial % 7);
    const auto vectors = about_an_axis(inputs, m, Dimension, spread);
    const auto h =
        instantiate::load<Form::bernstein, Dimension>(CurveView<double>{Form::bernstein, Dimension, m, vectors});
    const reference::LengthPanels<reference::LongReal> truth({Dimension, {vectors.begin(), vectors.end()}});
    ChebyshevSeries<Dimension> series(m);
    for (const double allowed : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
      series.expand(h, 4);
      series.shorten(allowed / 16);
      const auto rule = proved_rule(series, allowed);
      ++count.rules.at(static_cast<std::size_t>(rule.points / 8));
      if (rule.points == 0) continue;
      Speed<Dimension> speed(h);
      const double mean = rule.points == 8    ? gauss_integral<8>(speed)
                          : rule.points == 16 ? gauss_integral<16>(speed)
                                              : gauss_integral<24>(speed);
      const auto error = abs(truth.length() - mean).template convert_to<double>();
      EXPECT_LE(rule.missed, allowed);
      EXPECT_LE(error, rule.missed + rounding_of_length(h, 6 * m + 32))
          << "degree " << m << " axes " << Dimension << " allowed " << allowed << " points " << rule.points;
    }
  }
}

TEST(ProvedRule, MissesNoMoreThanItSays) {
  Count count;
  expect_proofs_to_hold<1>(count);
  expect_proofs_to_hold<2>(count);
  expect_proofs_to_hold<3>(count);
  for (const int often : count.rules) EXPECT_GT(often, 20);  // none of these outcomes is rare
}

/// h.h = 1 + z^2 / b^2 has the roots i b and -i b, and no ellipse that contains one may be used. A rule misses about
/// rho^(-2N) with rho = b + sqrt(1 + b^2), so that no smaller bound can be true.
TEST(ProvedRule, KnowsWhereTheSpeedHasRoots) {
  for (const double b : {0.5, 0.8, 1.0, 1.5, 2.0, 3.0}) {
    const std::vector<double> vectors{1, -1 / b, 1, 1 / b};
    const auto h = instantiate::load<Form::bernstein, 2>(CurveView<double>{Form::bernstein, 2, 1, vectors});
    ChebyshevSeries<2> series(1);
    series.expand(h, std::hypot(1, 1 / b));
    for (const double allowed : {1e-2, 1e-4, 1e-8, 1e-12, 1e-14}) {
      const auto rule = proved_rule(series, allowed);
      if (b < 1) {
        EXPECT_EQ(rule.points, 0) << b;
      }
      if (rule.points > 0) {
        EXPECT_GE(rule.missed, std::pow(b + std::sqrt(1 + b * b), -2 * rule.points)) << b << " " << allowed;
      }
    }
  }
}

TEST(ProvedRule, NeedsASpeedAndRoom) {
  ChebyshevSeries<2> series(2);
  Curve<Form::bernstein, double, 2> zero(2);
  for (int i = 0; i <= 2; ++i) zero(0, i) = zero(1, i) = 0;
  series.expand(zero, 0);
  EXPECT_EQ(proved_rule(series, 1).points, 0);
  for (int i = 0; i <= 2; ++i) zero(0, i) = 1;
  series.expand(zero, 1);
  EXPECT_EQ(proved_rule(series, 1e-6).points, 8);
  EXPECT_EQ(proved_rule(series, 2 * series.cut()).points, 0);  // the rounding error of the series is as large
}

TEST(ProvedRule, CountsWhatWasCut) {
  const std::vector<double> vectors{1, -1e-4, 1, 1e-4};
  const auto h = instantiate::load<Form::bernstein, 2>(CurveView<double>{Form::bernstein, 2, 1, vectors});
  ChebyshevSeries<2> series(1);
  series.expand(h, 1.1);
  series.shorten(1e-3);
  EXPECT_EQ(series.degree(), 0);
  EXPECT_EQ(proved_rule(series, 1e-3).missed, 2 * series.cut());
  EXPECT_GE(series.cut(), 1e-4);
  EXPECT_EQ(proved_rule(series, 1.9e-4).points, 0);
}

TEST(ProvedRule, IsThatOfTheTheorem) {
  for (std::size_t i = 0; i < detail::ellipse_count; ++i) {
    const double rho = std::exp2((static_cast<double>(i) + 1) / 16);
    EXPECT_NEAR(detail::ellipses.half_axis[i], (rho + 1 / rho) / 2, 1e-13 * rho);
    for (std::size_t r = 0; r < detail::gauss_rules; ++r) {
      const double exact = 32.0 / 15 * std::pow(rho, -16.0 * (static_cast<double>(r) + 1)) / (1 - std::pow(rho, -2));
      EXPECT_GE(detail::ellipses.missed[r][i], exact);
      EXPECT_LE(detail::ellipses.missed[r][i], exact * (1 + 0x1p-19));
    }
  }
}

}  // namespace
}  // namespace bezierbench
