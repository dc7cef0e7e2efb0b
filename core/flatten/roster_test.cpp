// SPDX-License-Identifier: MIT
// Every method for flattening: what all of them share, what some promise, and curves of public threads.
#include "core/flatten/roster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "core/flatten/kernel.hpp"
#include "reference/companion/chord_distance.hpp"
#include "reference/companion/exact_roots.hpp"

namespace bezierbench {
namespace {

using reference::Kept;

Flattening flattened(const FlattenKernel& kernel, const CurveView<double>& curve, double tolerance) {
  Flattening chords;
  kernel.flatten(curve, tolerance, chords);
  return chords;
}

CurveView<double> in_plane(const std::vector<double>& control_points) {
  return {Form::bernstein, 2, static_cast<int>(control_points.size()) / 2 - 1, control_points};
}

/// The curve, with weights for a method of rational curves.
CurveView<double> for_method(const FlattenKernel& kernel, CurveView<double> curve) {
  static constexpr std::array weights{1.0, 0.5, 3.0, 0.25};
  if (kernel.info->form != Form::rational) return curve;
  curve.form = Form::rational;
  curve.weights = std::span(weights).first(static_cast<std::size_t>(curve.degree) + 1);
  return curve;
}

const FlattenKernel& kernel_named(std::string_view id, int dimension = 2) {
  return *std::ranges::find_if(flatten_kernels(dimension), [&](const auto& one) { return one.info->id == id; });
}

/// Of all chords: `proved` if every one is, `refuted` if one is. Where the largest distance goes, if asked.
Kept judged(const CurveView<double>& curve, const Flattening& chords, double tolerance, double* largest = nullptr) {
  const reference::ScaledCurve scaled(curve);
  const auto d = static_cast<std::size_t>(curve.dimension);
  auto all = Kept::proved;
  for (std::size_t k = 0; k + 1 < chords.t.size(); ++k) {
    const std::span points(chords.points);
    const auto [distance, kept] = reference::judge_chord(scaled, chords.t[k], chords.t[k + 1], points.subspan(k * d, d),
                                                         points.subspan((k + 1) * d, d), tolerance);
    if (largest != nullptr) *largest = std::max(*largest, distance.low);
    if (kept == Kept::refuted || (kept == Kept::undecided && all == Kept::proved)) all = kept;
  }
  return all;
}

/// Curves that are awkward for one method or another, of size 1.
std::vector<double> awkward(int kind, int degree, int dimension, Inputs& inputs) {
  auto b = inputs.coefficients(degree, dimension);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t k = 0; k < b.size(); ++k) switch (kind) {
      case 0: break;                                                          // random
      case 1: b[k] = std::round(b[k]); break;                                 // loops, cusps, points
      case 2: b[k] *= k % d == 0 ? 1 : 0x1p-20; break;                        // nearly on a line
      case 3: b[k] = 100 + b[k]; break;                                       // far from the origin
      case 4: b[k] *= 0x1p-900; break;                                        // tiny
      case 5: b[k] *= 0x1p+900; break;                                        // huge
      case 6: b[k] = k < d ? b[k] : b[k - d] * (k / d == 2 ? -1 : 1); break;  // coinciding control points
      default: b[k] = b[std::min(k, b.size() - d - k / d * d + k % d)];       // its own reverse
    }
  return b;
}
constexpr int awkward_kinds = 8;
constexpr double sizes[awkward_kinds] = {1, 1, 1, 1, 0x1p-900, 0x1p+900, 1, 1};

template <class Check>
void for_awkward_curves(const Check& check) {
  Inputs inputs(11);
  for (int trial = 0; trial < 30 * awkward_kinds; ++trial) {
    const int kind = trial % awkward_kinds;
    const int degree = 1 + trial / awkward_kinds % 3;
    const int dimension = 1 + static_cast<int>(inputs.unit() * 3);
    const auto b = awkward(kind, degree, dimension, inputs);
    const double tolerance = sizes[kind] * (trial % 2 == 0 ? 0.07 : 0.0007);
    for (const auto& kernel : flatten_kernels(dimension))
      if (kernel.info->supports<double>(degree))
        check(kernel, for_method(kernel, {Form::bernstein, dimension, degree, b}), tolerance);
  }
}

TEST(Flatten, ChordsLeadFromEndToEnd) {
  for_awkward_curves([](const FlattenKernel& kernel, const CurveView<double>& curve, double tolerance) {
    const auto chords = flattened(kernel, curve, tolerance);
    const auto d = static_cast<std::size_t>(curve.dimension);
    ASSERT_GE(chords.t.size(), 2U) << kernel.info->id;
    ASSERT_EQ(chords.points.size(), chords.t.size() * d) << kernel.info->id;
    EXPECT_EQ(chords.t.front(), 0) << kernel.info->id;
    EXPECT_EQ(chords.t.back(), 1) << kernel.info->id;
    EXPECT_TRUE(std::ranges::is_sorted(chords.t)) << kernel.info->id;
    EXPECT_TRUE(std::ranges::equal(std::span(chords.points).first(d), curve.coefficients.first(d))) << kernel.info->id;
    EXPECT_TRUE(std::ranges::equal(std::span(chords.points).last(d), curve.coefficients.last(d))) << kernel.info->id;
  });
}

TEST(Flatten, WhoPromisesTheToleranceKeepsIt) {
  int judged_count = 0;
  for_awkward_curves([&](const FlattenKernel& kernel, const CurveView<double>& curve, double tolerance) {
    if (!kernel.keeps_tolerance) return;
    const auto chords = flattened(kernel, curve, tolerance);
    EXPECT_TRUE(chords.complete) << kernel.info->id;
    EXPECT_EQ(judged(curve, chords, tolerance), Kept::proved) << kernel.info->id << " degree " << curve.degree;
    ++judged_count;
  });
  EXPECT_GT(judged_count, 200);
}

/// No crack between two faces that share an edge in opposite directions.
TEST(Flatten, WhoPromisesTheSamePointsForTheReversedCurveHasThem) {
  int compared = 0;
  for_awkward_curves([&](const FlattenKernel& kernel, const CurveView<double>& curve, double tolerance) {
    if (!kernel.reverses) return;
    const auto d = static_cast<std::size_t>(curve.dimension);
    const auto reversed_points = [d](std::span<const double> points) {
      std::vector<double> reversed;
      for (std::size_t k = points.size(); k > 0; k -= d)
        reversed.insert(reversed.end(), points.begin() + static_cast<std::ptrdiff_t>(k - d),
                        points.begin() + static_cast<std::ptrdiff_t>(k));
      return reversed;
    };
    const auto b = reversed_points(curve.coefficients);
    const auto chords = flattened(kernel, {Form::bernstein, curve.dimension, curve.degree, b}, tolerance);
    EXPECT_EQ(reversed_points(chords.points), flattened(kernel, curve, tolerance).points) << kernel.info->id;
    ++compared;
  });
  EXPECT_GT(compared, 200);
}

/// A quarter of the curve at a quarter of the tolerance has the same parameters: square roots of 4 are exact, too.
TEST(Flatten, ScalingByFourChangesNoParameter) {
  Inputs inputs(12);
  for (int trial = 0; trial < 20; ++trial) {
    const auto b = inputs.coefficients(3, 2);
    auto quarter = b;
    for (double& x : quarter) x *= 0.25;
    for (const auto& kernel : flatten_kernels(2)) {
      if (!kernel.info->supports<double>(3)) continue;
      const auto chords = flattened(kernel, for_method(kernel, in_plane(b)), 1e-3);
      EXPECT_EQ(chords.t, flattened(kernel, for_method(kernel, in_plane(quarter)), 0.25e-3).t) << kernel.info->id;
    }
  }
}

/// The count of Wang's bound for the parabola (0,0), (1,2), (2,0): |C''| = 8, so that the tolerance 1/4 takes 2 chords
/// and 1/64 takes 8, exactly; their error is the tolerance.
TEST(Flatten, WangsCountOfAParabolaIsExact) {
  const std::vector<double> parabola{0, 0, 1, 2, 2, 0};
  for (const double tolerance : {0.25, 0x1p-6}) {
    const auto chords = flattened(kernel_named("wang_count"), in_plane(parabola), tolerance);
    EXPECT_EQ(chords.t.size(), 1 + std::sqrt(1 / tolerance));
    EXPECT_LE(reference::ScaledCurve(in_plane(parabola)).slack(), 1e-12);
    EXPECT_EQ(judged(in_plane(parabola), chords, tolerance), Kept::proved);
  }
}

/// [Levien 2019]: n chords have errors in the limit that are all E, so that a quarter of E takes twice as many.
TEST(Flatten, FourTimesFinerTakesTwiceTheChords) {
  const std::vector<double> cubic{0, 0, 0.25, 0.75, 0.75, 1, 1, 0.25};
  for (const auto& kernel : flatten_kernels(2)) {
    if (!kernel.info->supports<double>(3)) continue;
    const auto curve = for_method(kernel, in_plane(cubic));
    const double coarse = static_cast<double>(flattened(kernel, curve, 0x1p-16).t.size()) - 1;
    const double fine = static_cast<double>(flattened(kernel, curve, 0x1p-18).t.size()) - 1;
    EXPECT_NEAR(fine / coarse, 2, 0.03) << kernel.info->id;
  }
}

/// The second curve of nical/lyon#547, where the library's Hain was 0.016 off after a first repair, at tolerance 0.01.
TEST(Flatten, Lyon547) {
  const std::vector<double> b{7.0338364, 60.40962, 5.5532045, 62.335873, 6.1438327, 61.547035, 3.9364057, 60.891937};
  double distance = 0;
  const auto hain = flattened(kernel_named("hain"), in_plane(b), 0.01);
  EXPECT_EQ(judged(in_plane(b), hain, 0.01, &distance), Kept::refuted);
  EXPECT_GT(distance, 0.016);
  for (const auto id : {"equal_errors", "wang_count", "halving_distance"})
    EXPECT_EQ(judged(in_plane(b), flattened(kernel_named(id), in_plane(b), 0.01), 0.01), Kept::proved) << id;
}

/// linebender/kurbo#426: a cubic on a line that turns back twice. x' / 3 = -10 + 400 t - 510 t^2 is 0 at the second
/// turn, from which the curve returns to x = 60. Criteria that look at the line of a chord miss it, too.
TEST(Flatten, Kurbo426) {
  const std::vector<double> b{0, 10, -10, 10, 180, 10, 60, 10};
  const double t = (400 + std::sqrt(139600.0)) / 1020;
  const double turn = -30 * t * (1 - t) * (1 - t) + 540 * t * t * (1 - t) + 60 * t * t * t;
  double distance = 0;
  const auto levien = flattened(kernel_named("levien"), in_plane(b), 0.25);
  EXPECT_EQ(judged(in_plane(b), levien, 0.25, &distance), Kept::refuted);
  EXPECT_NEAR(distance, turn - 60, 0.05);
  const auto area = flattened(kernel_named("halving_area"), in_plane(b), 0.25);
  EXPECT_EQ(judged(in_plane(b), area, 0.25), Kept::refuted);
  // Between its ends and the two turns the curve runs straight, so that three chords suffice.
  EXPECT_LE(flattened(kernel_named("equal_errors"), in_plane(b), 0.25).t.size(), 4U);
  for (const auto id : {"equal_errors", "wang_count", "halving_distance", "halving_angle", "hybrid_differences"})
    EXPECT_EQ(judged(in_plane(b), flattened(kernel_named(id), in_plane(b), 0.25), 0.25), Kept::proved) << id;
}

/// Weights over eight binades, and of both signs inside: the two methods that promise the tolerance keep it, or say
/// that they did not.
TEST(Flatten, RationalCurvesKeepTheTolerance) {
  Inputs inputs(13);
  int proved = 0;
  int with_signs = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 2 + trial % 4;
    const int d = 1 + trial % 3;
    const auto b = inputs.coefficients(n, d);
    std::vector<double> weights;
    for (int i = 0; i <= n; ++i) {
      const bool inside = i > 0 && i < n;
      weights.push_back(trial % 2 == 1 && inside ? inputs.symmetric() : std::exp2(4 * inputs.symmetric()));
    }
    const CurveView<double> curve{Form::rational, d, n, b, weights};
    if (reference::pole(curve)) continue;
    const bool mixed = std::ranges::any_of(weights, [](double w) { return w < 0; });
    for (const auto id : {"halving_distance", "zheng_sederberg_count"}) {
      const auto& kernel = *std::ranges::find_if(
          flatten_kernels(d), [&](const auto& one) { return one.info->id == id && one.info->form == Form::rational; });
      const auto chords = flattened(kernel, curve, 1e-3);
      if (!chords.complete) {
        EXPECT_TRUE(mixed) << id << " trial " << trial;
        continue;
      }
      EXPECT_EQ(judged(curve, chords, 1e-3), Kept::proved) << id << " trial " << trial;
      ++(mixed ? with_signs : proved);
    }
  }
  EXPECT_GT(proved, 400);
  EXPECT_GT(with_signs, 40);
}

/// Points are multiples of 2^-1074, which such a tolerance does not leave room for.
TEST(Flatten, NoMethodSaysThatItKeepsASubnormalTolerance) {
  const std::vector<double> cubic{0, 0, 1e-310, 2e-310, 3e-310, -1e-310, 4e-310, 0};
  for (const auto& kernel : flatten_kernels(2)) {
    if (!kernel.info->supports<double>(3)) continue;
    EXPECT_FALSE(flattened(kernel, for_method(kernel, in_plane(cubic)), 1e-318).complete) << kernel.info->id;
  }
}

/// As a study of the smallest coordinates asks for it.
TEST(Flatten, NoToleranceIsTooFineToReturn) {
  const std::vector<double> cubic{0, 0, 1, 2, 3, -1, 4, 0};
  for (const auto& kernel : flatten_kernels(2)) {
    if (!kernel.info->supports<double>(3)) continue;
    for (const double tolerance : {1e-100, 1e-300, 0x1p-1074}) {
      const auto chords = flattened(kernel, for_method(kernel, in_plane(cubic)), tolerance);
      EXPECT_FALSE(chords.complete) << kernel.info->id << " " << tolerance;
      EXPECT_EQ(chords.points.size(), 2 * chords.t.size()) << kernel.info->id;
    }
  }
}

/// Neither tiny nor huge coordinates and weights change a parameter, also where their squares and products leave the
/// range of double.
TEST(Flatten, ScalingByAnyPowerOfTwoChangesNoParameter) {
  Inputs inputs(14);
  for (int trial = 0; trial < 6; ++trial) {
    const auto b = inputs.coefficients(3, 2);
    for (const auto& kernel : flatten_kernels(2)) {
      if (!kernel.info->supports<double>(3)) continue;
      const auto curve = for_method(kernel, in_plane(b));
      const auto chords = flattened(kernel, curve, 1e-3);
      for (const int exponent : {-900, -600, 500, 1022}) {
        auto scaled = b;
        for (double& x : scaled) x = std::ldexp(x, exponent);
        for (const int of_weights : {-1000, 0, 1000}) {
          auto weights = std::vector<double>(curve.weights.begin(), curve.weights.end());
          for (double& w : weights) w = std::ldexp(w, of_weights);
          const CurveView<double> all{curve.form, 2, 3, scaled, weights};
          const auto same = flattened(kernel, all, std::ldexp(1e-3, exponent));
          EXPECT_EQ(same.t, chords.t) << kernel.info->id << " " << exponent;
          EXPECT_EQ(same.complete, chords.complete) << kernel.info->id;
          for (std::size_t k = 0; k < same.points.size(); ++k)
            EXPECT_EQ(same.points[k], std::ldexp(chords.points[k], exponent)) << kernel.info->id;
        }
      }
    }
  }
}

/// A chord of the unit circle over the angle a is 1 - cos(a/2) from it: a quarter takes pi / (4 acos(1 - E)) chords. No
/// method has fewer. Equal steps of this parameter turn 1.17 times as far in the middle as at the ends, and halving
/// doubles the number of chords.
TEST(Flatten, AQuarterCircle) {
  const std::vector<double> points{1, 0, 1, 1, 0, 1};
  const std::vector<double> weights{1, std::sqrt(0.5), 1};
  const CurveView<double> circle{Form::rational, 2, 2, points, weights};
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const double least = std::acos(0.0) / (2 * std::acos(1 - tolerance));
    const auto bounds = reference::least_chords(reference::ScaledCurve(circle), tolerance);
    EXPECT_EQ(bounds.high, std::ceil(least));
    EXPECT_EQ(bounds.low, bounds.high);
    for (const auto& kernel : flatten_kernels(2)) {
      if (kernel.info->form != Form::rational) continue;
      const auto chords = flattened(kernel, circle, tolerance);
      EXPECT_GE(static_cast<double>(chords.t.size()) - 1, least) << kernel.info->id;
      if (kernel.info->id != "halving_length") {
        EXPECT_LE(static_cast<double>(chords.t.size()) - 1, 2.4 * least + 2) << kernel.info->id;
      }
    }
  }
}

/// M(r) of equal_errors.hpp at 20,000 t.
TEST(EqualErrors, NoPointIsFartherThanItsBoundFromTheInnerControlPoints) {
  for (int k = -64; k <= 64; ++k) {
    const double r = k / 64.0;
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double t = i / 20000.0;
      largest = std::max(largest, std::abs(3 * t * (1 - t) * ((1 - t) + t * r)));
    }
    EXPECT_GE(equal_errors::largest_distance(1, r), largest) << "r " << r;
    EXPECT_LE(equal_errors::largest_distance(1, r), 1.05 * largest) << "r " << r;
  }
}

}  // namespace
}  // namespace bezierbench
