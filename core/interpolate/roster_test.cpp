// SPDX-License-Identifier: MIT
// Known splines, properties of every method, and the residuals that the first method promises.
#include "core/interpolate/roster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/evaluate/evaluation_test.hpp"
#include "core/interpolate/kernel.hpp"
#include "reference/companion/interpolation.hpp"

namespace bezierbench {
namespace {

constexpr double u = 0x1p-53;

double size_of(std::span<const double> k) {
  double largest = 0;
  for (const double x : k) largest = std::max(largest, std::abs(x));
  return largest;
}

/// The largest residual over u max|K|; 0 / 0 is 0.
double residual_u(std::span<const double> k, std::span<const double> segments) {
  const auto all = reference::spline_residuals(k, segments);
  double largest = 0;
  for (const auto* residual : {&all.data, &all.c0, &all.c1, &all.c2, &all.natural})
    largest = std::max(largest, reference::round_to(reference::binary64, *residual));
  return largest == 0 ? 0 : largest / size_of(k) / u;
}

double inner_point_error_u(std::span<const double> k, std::span<const double> segments) {
  const auto error = reference::inner_point_error(reference::exact_spline(k), segments);
  return error.numerator == 0 ? 0 : reference::round_to(reference::binary64, error) / size_of(k) / u;
}

/// Points on which splines lose accuracy: random, signs only, whole numbers that coincide, far from 0, of all
/// magnitudes.
std::vector<double> points_of(int kind, std::size_t count, Inputs& inputs) {
  std::vector<double> k;
  const double range = 0.5 + 0.5 * inputs.unit();
  for (std::size_t i = 0; i < count; ++i) {
    const double x = inputs.symmetric();
    switch (kind) {
      case 0: k.push_back(x); break;
      case 1: k.push_back(x < 0 ? -range : range); break;
      case 2: k.push_back(std::floor(2 * x)); break;
      case 3: k.push_back(1e6 + x); break;
      default: k.push_back(std::ldexp(x, -static_cast<int>(60 * inputs.unit()))); break;
    }
  }
  return k;
}

const InterpolationKernel& kernel_of(const MethodInfo& method) {
  return *std::ranges::find(interpolation_kernels(), &method, &InterpolationKernel::info);
}

/// 5/9, 8/9, -1/9 and 10/9, 1/9, 4/9, computed by hand from the corrected system of [Document 003].
TEST(Interpolation, OfZeroOneZeroOne) {
  const std::vector<double> k{0, 1, 0, 1};
  const std::vector<double> ninths{0, 5, 10, 9, 9, 8, 1, 0, 0, -1, 4, 9};
  for (const auto& kernel : interpolation_kernels()) {
    if (kernel.info == &Seed003::info) continue;
    const auto segments = kernel.interpolate(k, 1);
    ASSERT_EQ(segments.size(), ninths.size());
    for (std::size_t i = 0; i < ninths.size(); ++i)
      EXPECT_NEAR(segments[i], ninths[i] / 9, 2 * u) << kernel.info->id << " " << i;
  }
}

/// The back-substitution of [Document 003] as printed gives P2 = -5/9, 10/9, 4/9, by hand. At the knots the residuals
/// of C1 are (P1,i - K_i) - (K_i - P2,(i-1)) = -1/9 - 14/9 and -1/9 + 10/9. Only the last segment, whose P2 has a
/// formula of its own, is right.
TEST(SourceDocument, PrintedBackSubstitutionHasKinks) {
  const std::vector<double> k{0, 1, 0, 1};
  const auto segments = kernel_of(Seed003::info).interpolate(k, 1);
  const std::vector<double> ninths{0, 5, -5, 9, 9, 8, 10, 0, 0, -1, 4, 9};
  for (std::size_t i = 0; i < ninths.size(); ++i) EXPECT_NEAR(segments[i], ninths[i] / 9, 2 * u) << i;
  EXPECT_NEAR((segments[5] - k[1]) - (k[1] - segments[2]), -5.0 / 3, 4 * u);
  EXPECT_NEAR((segments[9] - k[2]) - (k[2] - segments[6]), 1, 4 * u);
  EXPECT_NEAR(reference::round_to(reference::binary64, reference::spline_residuals(k, segments).c1), 5.0 / 3, 4 * u);
}

/// The condition for C1 in the first form of [Document 003], with 3 P0 for -3 P0, does not hold for the spline itself;
/// 2 K_i = P2,(i-1) + P1,i does at the inner knots, and needs a segment -1 at i = 0, which is printed as its first
/// index.
TEST(SourceDocument, PrintedConditionForC1HasAWrongSign) {
  const auto b = kernel_of(C2NaturalHandles::info).interpolate(std::vector<double>{0, 1, 0, 1}, 1);
  const double printed = (3 * b[4] + 3 * b[5]) - (-3 * b[2] + 3 * b[3]);
  const double right = (-3 * b[4] + 3 * b[5]) - (-3 * b[2] + 3 * b[3]);
  EXPECT_NEAR(printed, 6 * b[4], 8 * u);  // 6, the residual
  EXPECT_NEAR(right, 0, 8 * u);
  EXPECT_NEAR(2 * b[4], b[2] + b[5], 4 * u);
}

/// The bound aimed at, 8 units, and the proved one, on difficult points of every magnitude.
TEST(Interpolation, KeepsTheResidualsThatItPromises) {
  Inputs inputs(1);
  double worst = 0;
  for (const double scale : {1.0, 0x1p-900, 0x1p+1000})
    for (const std::size_t count : {2U, 3U, 4U, 5U, 9U, 40U})
      for (int trial = 0; trial < 200; ++trial) {
        auto k = points_of(trial % 5, count, inputs);
        for (double& x : k) x *= scale;
        for (const auto& kernel : interpolation_kernels()) {
          const auto segments = kernel.interpolate(k, 1);
          const double residual = residual_u(k, segments);
          if (kernel.info == &Seed003::info) continue;
          if (kernel.residual_bound == 0) {
            worst = std::max(worst, residual);
            continue;
          }
          EXPECT_LE(kernel.residual_bound, 8);
          EXPECT_LE(residual, kernel.residual_bound) << kernel.info->id << " of " << count << ", trial " << trial;
          EXPECT_LE(inner_point_error_u(k, segments), std::sqrt(3) * (1 + 0x1p-40)) << kernel.info->id;
        }
      }
  EXPECT_GT(worst, 8);  // handles without refinement lose this much: these points distinguish the methods
}

/// Points of a few times the smallest double, on which all that remains of the bound is its underflow term.
TEST(Interpolation, KeepsItsResidualsWhereNumbersAreSubnormal) {
  Inputs inputs(4);
  bool above_first_term = false;
  for (const double scale : {0x1p-1070, 0x1p-1050, 0x1p-1021})
    for (const std::size_t count : {2U, 3U, 4U, 9U})
      for (int trial = 0; trial < 500; ++trial) {
        auto k = points_of(trial % 3, count, inputs);
        for (double& x : k) x *= scale;
        const auto& kernel = interpolation_kernels().front();
        const auto first_term =
            reference::exactly(kernel.residual_bound) * reference::exactly(size_of(k)) * reference::Rational{1, 1, -53};
        const auto limit = first_term + reference::Rational{residual_underflow, 1, -1074};
        const auto all = reference::spline_residuals(k, kernel.interpolate(k, 1));
        for (const auto* residual : {&all.data, &all.c0, &all.c1, &all.c2, &all.natural}) {
          EXPECT_LE((*residual - limit).numerator, 0) << count << " times " << scale << ", trial " << trial;
          above_first_term = above_first_term || (*residual - first_term).numerator > 0;
        }
      }
  EXPECT_TRUE(above_first_term);
}

/// The bound rests on the sums of the weights of the points: in |P|, and in each residual if every control point has an
/// error of u |P|. Unit points give the weights; the sums are largest inside long splines.
TEST(Interpolation, WeightsAreThoseOfTheBound) {
  for (const std::size_t n : {1U, 2U, 3U, 6U, 40U}) {
    std::vector<std::vector<double>> weights;  // weights of each K_m in all control points
    for (std::size_t m = 0; m <= n; ++m) {
      std::vector<double> k(n + 1, 0);
      k[m] = 1;
      weights.push_back(interpolation_kernels().front().interpolate(k, 1));
    }
    /// One term, factor |P_at|, of a sum. `most` returns the largest value of the sum over all |K| <= 1.
    struct Term {
      double factor;
      std::size_t at;
    };
    const auto most = [&](const std::vector<Term>& terms) {
      double largest = 0;
      for (unsigned signs = 0; signs < (1U << terms.size()); ++signs) {
        double sum = 0;
        for (const auto& weight : weights) {
          double part = 0;
          for (std::size_t j = 0; j < terms.size(); ++j)
            part += ((signs >> j & 1U) != 0 ? -1 : 1) * terms[j].factor * weight[terms[j].at];
          sum += std::abs(part);
        }
        largest = std::max(largest, sum);
      }
      return largest;
    };
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t p1 = 4 * i + 1;
      const std::size_t p2 = p1 + 1;
      EXPECT_LE(most({{1, p1}}), std::sqrt(3));
      EXPECT_LE(most({{1, p2}}), std::sqrt(3));
      if (i == 0) continue;
      EXPECT_LE(most({{1, p1}, {1, p2 - 4}}), 2 * (1 + 10 * u));
      EXPECT_LE(most({{2, p1}, {1, p2}, {1, p1 - 4}, {2, p2 - 4}}), 14 - 4 * std::sqrt(3));
    }
    EXPECT_LE(most({{2, 1}, {1, 2}}), 4.24);
    EXPECT_LE(most({{1, 4 * n - 3}, {2, 4 * n - 2}}), 4.24);
  }
}

TEST(Interpolation, OfASegmentAndOfCoincidingPointsIsStraight) {
  for (const auto& kernel : interpolation_kernels()) {
    EXPECT_EQ(kernel.interpolate(std::vector<double>{1, 7, -2, -5}, 2),
              (std::vector<double>{1, 7, 0, 3, -1, -1, -2, -5}));
    for (const double x : {0.0, 0.1, -1e300, 5e-324})
      for (const std::size_t count : {2U, 3U, 50U})
        for (const double value : kernel.interpolate(std::vector<double>(count, x), 1))
          EXPECT_NEAR(value, x, 4 * u * std::abs(x)) << kernel.info->id;
  }
}

/// Sums of coordinates overflow long before control points do.
TEST(Interpolation, TakesTheLargestAndTheSmallestNumbers) {
  const std::vector<double> large{1.7e308, -1.7e308, 1.7e308, 1.6e308};
  for (const auto& kernel : interpolation_kernels()) {
    if (kernel.info == &Seed003::info) continue;
    const auto segments = kernel.interpolate(std::vector<double>{1e308, -1e308, 1e308, 1e308}, 1);
    for (const double value : segments) EXPECT_TRUE(std::isfinite(value)) << kernel.info->id;
    const auto beyond = kernel.interpolate(large, 1);
    EXPECT_EQ(beyond[0], large[0]);
    for (const double value : beyond) EXPECT_FALSE(std::isnan(value));
    const auto small = kernel.interpolate(std::vector<double>{0, 9 * 5e-324, 0, 9 * 5e-324}, 1);
    EXPECT_EQ(small, (std::vector<double>{0, 5 * 5e-324, 10 * 5e-324, 9 * 5e-324, 9 * 5e-324, 8 * 5e-324, 5e-324, 0, 0,
                                          -5e-324, 4 * 5e-324, 9 * 5e-324}))
        << kernel.info->id;
  }
}

/// A million points take a moment only, and the spline is as accurate in the middle as at its ends.
TEST(Interpolation, OfAMillionPoints) {
  Inputs inputs(3);
  const auto k = points_of(0, 1'000'000, inputs);
  for (const auto& kernel : interpolation_kernels()) {
    const auto segments = kernel.interpolate(k, 1);
    ASSERT_EQ(segments.size(), 4 * (k.size() - 1));
    for (const auto& [from, at] : {std::pair{0UL, 0UL}, {k.size() / 2, 40UL}, {k.size() - 81, 79UL}}) {
      // points 40 or more away change a control point by less than (2 - sqrt(3))^40 = 1e-22
      const auto local = reference::exact_spline(std::span(k).subspan(from, 81));
      EXPECT_NEAR(segments[4 * (from + at) + 1], reference::round_to(reference::binary64, local.first[at]), 4 * u)
          << kernel.info->id << " " << from;
    }
  }
}

}  // namespace
}  // namespace bezierbench
