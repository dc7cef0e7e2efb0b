// SPDX-License-Identifier: MIT
// A proved rule misses no more than the proof says, compared with the mean speed to 70 digits.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/arc_length/chebyshev_series.hpp"
#include "core/arc_length/gauss_legendre.hpp"
#include "core/arc_length/gauss_legendre_adaptive.hpp"
#include "core/arc_length/speed.hpp"
#include "core/arc_length/squared_speeds.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
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

// The series of Chebyshev polynomials, whose control points are known, have one term.

namespace {

/// The control points of T_n(2t - 1): (-1)^(n-i) C(2n, 2i) / C(n, i) ([Rababah 2003]).
/// With t = cos^2 v, T_n(2t - 1) = cos 2nv is the real part of (cos v + i sin v)^(2n).
std::vector<double> control_points(int n) {
  std::vector<double> points{n % 2 == 0 ? 1.0 : -1.0};
  for (int i = 1; i <= n; ++i) points.push_back(-points.back() * (2 * (n - i) + 1) / (2 * i - 1));
  return points;
}

TEST(ChebyshevSeries, OfAChebyshevPolynomialIsItself) {
  for (int n = 1; n <= 40; ++n) {
    const auto points = control_points(n);
    const auto curve = instantiate::load<Form::bernstein, 1>(CurveView<double>{Form::bernstein, 1, n, points});
    const double largest = std::ranges::max(points);
    ChebyshevSeries<1> series(n);
    with_fixed_degree(curve, [&](const auto& fixed) { series.expand(fixed, largest); });
    const auto of_fixed = series;
    series.expand(curve, largest);
    for (std::size_t k = 0; k <= series.degree(); ++k) EXPECT_EQ(series.size(k), of_fixed.size(k)) << n << " " << k;
    const double rounding = series.rounding(largest);
    const bool is_cut = n > static_cast<int>(series.degree_limit);
    if (is_cut) {
      EXPECT_GE(series.cut(), 1) << n;  // the distance of T_n from any polynomial of lower degree
      continue;
    }
    EXPECT_EQ(series.cut(), rounding) << n;
    for (std::size_t k = 0; k <= series.degree(); ++k)
      EXPECT_NEAR(series.size(k), k == static_cast<std::size_t>(n) ? 1 : 0, rounding) << n << " " << k;
  }
}

/// The size of a term and the cut include every axis. One series serves many curves.
TEST(ChebyshevSeries, CombinesAxes) {
  ChebyshevSeries<3> series(5);
  Curve<Form::bernstein, double, 3> curve(5);
  const auto points = control_points(5);
  for (const double scale : {1.0, 0.5}) {
    for (int i = 0; i <= 5; ++i) {
      curve(0, i) = 3 * scale * points[static_cast<std::size_t>(i)];
      curve(1, i) = 4 * scale * points[static_cast<std::size_t>(i)];
      curve(2, i) = 7 * scale;
    }
    series.expand(curve, 100);
    const double rounding = series.rounding(100);
    EXPECT_NEAR(series.size(0), 7 * scale, rounding);
    EXPECT_NEAR(series.size(5), 5 * scale, rounding);
    for (const std::size_t k : {1U, 2U, 3U, 4U}) EXPECT_LE(series.size(k), rounding);
    series.shorten(4.9 * scale);
    EXPECT_EQ(series.degree(), 5);
    series.shorten(5.1 * scale);
    EXPECT_EQ(series.degree(), 0);
    EXPECT_NEAR(series.cut(), 5 * scale, 10 * rounding);
  }
}

}  // namespace

// Eight speeds that are computed at once have the same bits as when each is computed alone.

namespace {

template <int Dimension>
double squared_norm_at(const Curve<Form::bernstein, double, Dimension>& curve, double t) {
  const auto point = DeCasteljau::evaluate(DeCasteljau::prepare(curve), t);
  double sum = 0;
  for (int axis = 0; axis < Dimension; ++axis) sum += point[axis] * point[axis];
  return sum;
}

template <int Dimension>
void expect_those_of_de_casteljau() {
  const auto squared_speeds = std::make_unique<SquaredSpeeds<Dimension>>();  // one object serves all curves below
  Inputs inputs(11);
  for (const int degree : {20, 0, 1, 2, 3, 5, 10, max_degree, 4, 0}) {
    const auto points = inputs.coefficients(degree, Dimension);
    const auto h =
        instantiate::load<Form::bernstein, Dimension>(CurveView<double>{Form::bernstein, Dimension, degree, points});
    std::array<double, 8> parameters{0, 1, 0.5};
    for (std::size_t k = 3; k < parameters.size(); ++k) parameters[k] = inputs.unit();
    const auto expect_right = [&](const auto& squares) {
      for (std::size_t k = 0; k < parameters.size(); ++k)
        EXPECT_EQ(squares[k], squared_norm_at(h, parameters[k])) << degree << " " << parameters[k];
    };
    expect_right((*squared_speeds)(h, parameters));
    with_fixed_degree(h, [&](const auto& fixed) { expect_right((*squared_speeds)(fixed, parameters)); });
  }
}

TEST(SquaredSpeeds, AreThoseOfDeCasteljau) {
  expect_those_of_de_casteljau<1>();
  expect_those_of_de_casteljau<2>();
  expect_those_of_de_casteljau<3>();
}

}  // namespace

}  // namespace bezierbench
