// SPDX-License-Identifier: MIT
// Splines of all parameters and ends against the exact ones, and what must hold of any.
#include "core/interpolate/spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/evaluation_test.hpp"
#include "reference/companion/interpolation.hpp"

namespace bezierbench {
namespace {

constexpr double u = 0x1p-53;
constexpr std::array every_parameters{Parameters::centripetal, Parameters::uniform, Parameters::chord};
constexpr std::array every_ends{SplineEnds::natural, SplineEnds::clamped, SplineEnds::not_a_knot};

std::vector<double> random_points(std::size_t count, Inputs& inputs) {
  std::vector<double> points;
  for (std::size_t k = 0; k < 2 * count; ++k) points.push_back(inputs.symmetric());
  return points;
}

std::vector<double> axis_of(std::span<const double> points, std::size_t axis) {
  std::vector<double> values;
  for (std::size_t k = axis; k < points.size(); k += 2) values.push_back(points[k]);
  return values;
}

reference::SplineSystem system_of(std::span<const double> steps, const SplineConditions& conditions, std::size_t axis) {
  using Ends = reference::SplineSystem::Ends;
  reference::SplineSystem system{steps};
  if (conditions.closed) {
    system.ends = Ends::closed;
  } else if (conditions.ends == SplineEnds::clamped) {
    system = {steps, Ends::clamped, conditions.start_derivative[axis], conditions.end_derivative[axis]};
  } else if (conditions.ends == SplineEnds::not_a_knot) {
    system.ends = Ends::not_a_knot;
  }
  return system;
}

/// The largest error of an inner control point on one axis, over the largest control point of the exact spline.
double error_on(std::size_t axis, std::span<const double> points, std::span<const double> steps,
                const SplineConditions& conditions, std::span<const double> segments) {
  auto k = axis_of(points, axis);
  if (conditions.closed) k.push_back(k.front());
  const auto exact = reference::exact_spline(k, system_of(steps, conditions, axis));
  double largest = 0;
  for (const double x : k) largest = std::max(largest, std::abs(x));
  for (const auto* inner : {&exact.first, &exact.second})
    for (const auto& x : *inner) largest = std::max(largest, std::abs(reference::round_to(reference::binary64, x)));
  const auto error = reference::inner_point_error(exact, axis_of(segments, axis));
  return error.numerator == 0 ? 0 : reference::round_to(reference::binary64, error) / largest;
}

/// Elimination of rows that are diagonally dominant by 1 has condition at most 3 in the largest norm, and slopes take
/// some ten roundings; not-a-knot rows are dominant by less, but still lose no digit more on points like these.
TEST(Spline, IsTheExactOneButForRounding) {
  Inputs inputs(1);
  const std::vector<double> start{0.5, -3};
  const std::vector<double> end{-0.25, 8};
  for (const std::size_t count : {2U, 3U, 4U, 5U, 12U})
    for (int trial = 0; trial < 20; ++trial) {
      const auto points = random_points(count, inputs);
      const auto judge = [&](Parameters parameters, const SplineConditions& conditions, const char* name) {
        const auto steps = knot_steps(points, 2, parameters, conditions.closed);
        const auto segments = spline_segments(points, 2, steps, conditions);
        ASSERT_EQ(segments.size(), 8 * steps.size());
        for (const std::size_t axis : {0U, 1U})
          EXPECT_LE(error_on(axis, points, steps, conditions, segments), 50 * u)
              << name << " with " << parameters_names[static_cast<std::size_t>(parameters)] << " of " << count;
      };
      for (const auto parameters : every_parameters) {
        for (const auto ends : every_ends)
          judge(parameters, {ends, false, false, start, end}, spline_ends_names[static_cast<std::size_t>(ends)].data());
        judge(parameters, {.closed = true}, "closed");
      }
    }
}

/// t^3 - 2t^2 + 5, whose control points between a and b are its blossoms at (a,a,b) and (a,b,b).
TEST(Spline, ReproducesACubicWhereItsEndsDo) {
  const std::vector<double> t{0, 0.5, 2, 2.25, 3, 5};
  const auto blossom = [](double a, double b, double c) { return a * b * c - 2 * (a * b + a * c + b * c) / 3 + 5; };
  std::vector<double> points;
  std::vector<double> steps;
  std::vector<double> expected;
  for (std::size_t i = 0; i < t.size(); ++i) points.push_back(blossom(t[i], t[i], t[i]));
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    steps.push_back(t[i + 1] - t[i]);
    expected.insert(expected.end(),
                    {points[i], blossom(t[i], t[i], t[i + 1]), blossom(t[i], t[i + 1], t[i + 1]), points[i + 1]});
  }
  const std::vector<double> start{3 * (expected[1] - expected[0])};
  const std::vector<double> end{3 * (expected[19] - expected[18])};
  for (const auto ends : {SplineEnds::clamped, SplineEnds::not_a_knot}) {
    const auto segments = spline_segments(points, 1, steps, {ends, false, false, start, end});
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(segments[k], expected[k], 2000 * u);
  }
}

/// The parabola through three points, and a line through two.
TEST(Spline, OfFewPointsThatAreNoKnots) {
  const std::vector<double> steps{1, 1};
  const auto segments = spline_segments(std::vector<double>{0, 1, 4}, 1, steps, {SplineEnds::not_a_knot});
  const std::vector<double> square{0, 0, 1.0 / 3, 1, 1, 5.0 / 3, 8.0 / 3, 4};  // t^2 by its blossom
  for (std::size_t k = 0; k < square.size(); ++k) EXPECT_NEAR(segments[k], square[k], 4 * u);
  for (const auto ends : {SplineEnds::natural, SplineEnds::not_a_knot})
    EXPECT_EQ(spline_segments(std::vector<double>{3, 6}, 1, std::vector<double>{1.0}, {ends}),
              (std::vector<double>{3, 4, 5, 6}));
}

/// Points that ascend on a line: at chord-length parameters the spline is the line at constant speed, at centripetal
/// ones it is monotone (the proof is in spline.hpp), at uniform ones it runs back (0, 1, 100: to -8.86, by hand).
TEST(Spline, RunsBackAtUniformParametersOnly) {
  Inputs inputs(2);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<double> points{0};
    const std::size_t count = 3 + trial % 20;
    while (points.size() < count)
      points.push_back(points.back() + std::ldexp(1.0, static_cast<int>(40 * inputs.unit())));
    const double limit = 20 * u * points.back();
    const auto chord = spline_segments(points, 1, knot_steps(points, 1, Parameters::chord, false), {});
    const auto centripetal = spline_segments(points, 1, knot_steps(points, 1, Parameters::centripetal, false), {});
    for (std::size_t i = 0; i + 1 < count; ++i) {
      EXPECT_NEAR(chord[4 * i + 1], (2 * points[i] + points[i + 1]) / 3, limit);
      EXPECT_NEAR(chord[4 * i + 2], (points[i] + 2 * points[i + 1]) / 3, limit);
      for (const std::size_t k : {4 * i + 1, 4 * i + 2}) {
        EXPECT_GE(centripetal[k], points[i] - limit);
        EXPECT_LE(centripetal[k], points[i + 1] + limit);
      }
    }
  }
  const std::vector<double> report{0, 1, 100};
  const auto uniform = spline_segments(report, 1, knot_steps(report, 1, Parameters::uniform, false), {});
  EXPECT_NEAR(uniform[1], -23.5 / 3, 16 * u);
}

TEST(Spline, OfMonotoneDataIsMonotoneIfThatIsWanted) {
  Inputs inputs(3);
  for (int trial = 0; trial < 1000; ++trial) {
    const auto points = random_points(3 + trial % 9, inputs);
    for (const auto parameters : every_parameters)
      for (const bool closed : {false, true}) {
        const auto steps = knot_steps(points, 2, parameters, closed);
        const std::vector<double> derivative{100, -100};
        const auto ends = every_ends[static_cast<std::size_t>(trial) % 3];
        const auto segments = spline_segments(points, 2, steps, {ends, closed, true, derivative, derivative});
        for (std::size_t k = 0; k < segments.size(); k += 8)
          for (std::size_t axis = 0; axis < 2;
               ++axis) {  // within the points: Bernstein coefficients of a monotone cubic
            const auto [low, high] = std::minmax({segments[k + axis], segments[k + 6 + axis]});
            for (const double inner : {segments[k + 2 + axis], segments[k + 4 + axis]}) {
              EXPECT_GE(inner, low);
              EXPECT_LE(inner, high);
            }
            if (k == 0) continue;  // C1 in the parameter: handles are as long as their steps
            const double before = (segments[k + axis] - segments[k - 4 + axis]) / steps[k / 8 - 1];
            const double after = (segments[k + 2 + axis] - segments[k + axis]) / steps[k / 8];
            EXPECT_NEAR(before, after, 10 * u * (1 + 1 / std::min(steps[k / 8 - 1], steps[k / 8])));
          }
      }
  }
  // a slope within the limits stays: that of a spline which is monotone by itself
  const std::vector<double> points{0, 1, 3, 6};
  const auto steps = knot_steps(points, 1, Parameters::uniform, false);
  const auto free = spline_segments(points, 1, steps, {});
  const auto monotone = spline_segments(points, 1, steps, {.monotone = true});
  for (std::size_t k = 0; k < free.size(); ++k) EXPECT_NEAR(monotone[k], free[k], 50 * u);
}

TEST(KnotSteps, ArePowersOfDistances) {
  const std::vector<double> points{0, 0, 3, 4, 3, 24, 3, 24};  // distances 5, 20, 0, and back sqrt(585)
  EXPECT_EQ(knot_steps(points, 2, Parameters::uniform, false), (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(knot_steps(points, 2, Parameters::chord, false), (std::vector<double>{0.25, 1, 0}));
  const auto root = knot_steps(points, 2, Parameters::centripetal, false);
  EXPECT_NEAR(root[0], 0.5, 4 * u);
  EXPECT_EQ(root[1], 1);
  EXPECT_EQ(root[2], 0);
  const auto closed = knot_steps(points, 2, Parameters::chord, true);
  EXPECT_NEAR(closed[1], 20 / std::sqrt(585), 4 * u);
  EXPECT_EQ(closed[3], 1);
}

TEST(KnotSteps, OfTheLargestAndTheSmallestNumbers) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(knot_steps(std::vector<double>{-most, most, 0}, 1, Parameters::chord, false),
            (std::vector<double>{1, 0.5}));
  EXPECT_EQ(knot_steps(std::vector<double>{0, least, 5 * least}, 1, Parameters::chord, false),
            (std::vector<double>{0.25, 1}));
  EXPECT_EQ(knot_steps(std::vector<double>{0, least, 5 * least}, 1, Parameters::centripetal, false),
            (std::vector<double>{0.5, 1}));
  EXPECT_EQ(knot_steps(std::vector<double>{0, least, 1}, 1, Parameters::chord, false), (std::vector<double>{0, 1}));
}

}  // namespace
}  // namespace bezierbench
