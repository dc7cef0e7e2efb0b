// SPDX-License-Identifier: MIT
// Properties of every fitting method, then known results of each.
#include "core/fit/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluation_test.hpp"
#include "core/fit/kernel.hpp"
#include "reference/companion/polyline_departure.hpp"

namespace bezierbench {
namespace {

using Data = std::vector<double>;

/// Samples of a Bezier curve at equal steps of t.
Data samples(const Data& control, int d, int count) {
  const std::size_t n = control.size() / static_cast<std::size_t>(d) - 1;
  Data data;
  for (int k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / (count - 1);
    Data b = control;
    for (std::size_t last = n; last > 0; --last)
      for (std::size_t i = 0; i < last * static_cast<std::size_t>(d); ++i)
        b[i] = (1 - t) * b[i] + t * b[i + static_cast<std::size_t>(d)];
    data.insert(data.end(), b.begin(), b.begin() + d);
  }
  return data;
}

/// Data of several kinds: samples of curves, some closed, some with noise, and some with repeated points and steps
/// backwards.
Data any_data(Inputs& inputs, int kind, int d) {
  const int degree = 2 + kind % 5;
  auto control = inputs.coefficients(degree, d);
  if (kind % 4 == 1) std::copy_n(control.begin(), d, control.end() - d);
  auto data = samples(control, d, 5 + 7 * (kind % 6));
  if (kind % 4 == 2)
    for (double& x : data) x += 0x1p-8 * inputs.symmetric();
  if (kind % 4 == 3) {
    Data walk;
    const std::size_t count = data.size() / static_cast<std::size_t>(d);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = i % 5 == 4 ? i - 2 : i % 7 == 3 ? i - 1 : i;
      walk.insert(walk.end(), data.begin() + static_cast<std::ptrdiff_t>(k) * d,
                  data.begin() + static_cast<std::ptrdiff_t>(k + 1) * d);
    }
    return walk;
  }
  return data;
}

double coordinate(const Fit& fit, int d, int segment, int j, int axis) {
  return fit.control_points[static_cast<std::size_t>((4 * segment + j) * d + axis)];
}

/// The distance of data point i from the point of the curve with which it was compared.
double distance_of(const Fit& fit, const Data& data, int d, std::size_t i) {
  const long double t = fit.t[i];
  const long double s = 1 - t;
  long double square = 0;
  for (int axis = 0; axis < d; ++axis) {
    const auto b = [&](int j) { return coordinate(fit, d, fit.segment[i], j, axis); };
    const long double offset =
        s * s * s * b(0) + 3 * s * s * t * b(1) + 3 * s * t * t * b(2) + t * t * t * b(3) -
        static_cast<long double>(data[i * static_cast<std::size_t>(d) + static_cast<std::size_t>(axis)]);
    square += offset * offset;
  }
  return static_cast<double>(std::sqrt(square));
}

/// The cosine of the angle between the end of segment a and the beginning of segment b.
double cosine_at_joint(const Fit& fit, int d, int a, int b) {
  long double in = 0, out = 0, product = 0;
  for (int axis = 0; axis < d; ++axis) {
    const long double u = coordinate(fit, d, a, 3, axis) - coordinate(fit, d, a, 2, axis);
    const long double v = coordinate(fit, d, b, 1, axis) - coordinate(fit, d, b, 0, axis);
    in += u * u;
    out += v * v;
    product += u * v;
  }
  return static_cast<double>(product / std::sqrt(in * out));
}

TEST(Fitting, KeepsTheToleranceAndPassesTheEnds) {
  Inputs inputs(1);
  for (int trial = 0; trial < 240; ++trial)
    for (const double tolerance : {0.0, 0x1p-300, 1e-15, 1e-9, 1e-3, 0.1, 10.0}) {
      const int d = 1 + trial % 3;
      const auto data = any_data(inputs, trial, d);
      for (const auto& kernel : fitting_kernels(d)) {
        const auto fit = kernel.fit(data, tolerance, {});
        const auto where = testing::Message() << kernel.info->id << " trial " << trial << " tolerance " << tolerance;
        ASSERT_TRUE(fit.converged) << where;
        ASSERT_LE(fit.max_error, tolerance) << where;
        ASSERT_EQ(fit.t.size() * static_cast<std::size_t>(d), data.size()) << where;
        for (std::size_t i = 0; i < fit.t.size(); ++i)
          ASSERT_LE(distance_of(fit, data, d, i), fit.max_error) << where << " point " << i;
        const auto& b = fit.control_points;
        EXPECT_TRUE(std::equal(data.begin(), data.begin() + d, b.begin())) << where;
        EXPECT_TRUE(std::equal(data.end() - d, data.end(), b.end() - d)) << where;
        for (int s = 1; s < fit.segments(d); ++s)
          for (int axis = 0; axis < d; ++axis)
            ASSERT_EQ(coordinate(fit, d, s - 1, 3, axis), coordinate(fit, d, s, 0, axis));
      }
    }
}

/// A power of two scales every operation exactly, also where squares would overflow or underflow.
TEST(Fitting, ScalesWithTheData) {
  Inputs inputs(2);
  for (int trial = 0; trial < 48; ++trial)
    for (const double factor : {0x1p-900, 0x1p-30, 0x1p+33, 0x1p+1000}) {
      const int d = 1 + trial % 3;
      const auto data = any_data(inputs, trial, d);
      auto scaled = data;
      for (double& x : scaled) x *= factor;
      for (const auto& kernel : fitting_kernels(d)) {
        const auto one = kernel.fit(data, 0.01, {});
        const auto other = kernel.fit(scaled, 0.01 * factor, {});
        EXPECT_EQ(one.t, other.t) << kernel.info->id << " trial " << trial;
        EXPECT_EQ(one.max_error * factor, other.max_error) << kernel.info->id << " trial " << trial;
        auto expected = one.control_points;
        for (double& x : expected) x *= factor;
        EXPECT_EQ(expected, other.control_points) << kernel.info->id << " trial " << trial;
      }
    }
}

/// The data are on a lattice on which a shift is exact: only the roundings of handles differ.
TEST(Fitting, MovesWithTheData) {
  Inputs inputs(3);
  for (int trial = 0; trial < 48; ++trial) {
    const int d = 1 + trial % 3;
    auto data = any_data(inputs, trial, d);
    if (trial % 20 == 5) continue;  // a closed quadratic runs forth and back on a line, where handles are not unique
    for (double& x : data) x = std::floor(x * 0x1p+20) * 0x1p-20;
    auto moved = data;
    constexpr double shift = 0x1p+10;
    for (double& x : moved) x += shift;
    for (const auto& kernel : fitting_kernels(d)) {
      const auto one = kernel.fit(data, 0.01, {});
      const auto other = kernel.fit(moved, 0.01, {});
      ASSERT_EQ(one.segments(d), other.segments(d)) << kernel.info->id << " trial " << trial;
      for (std::size_t k = 0; k < one.control_points.size(); ++k)
        EXPECT_NEAR(one.control_points[k] + shift, other.control_points[k], 1e-6)
            << kernel.info->id << " trial " << trial;
    }
  }
}

TEST(Fitting, RunsBackwards) {
  Inputs inputs(4);
  for (int trial = 0; trial < 48; ++trial) {
    const int d = 1 + trial % 3;
    const auto data = any_data(inputs, trial, d);
    Data reversed;
    for (std::size_t i = data.size(); i > 0; i -= static_cast<std::size_t>(d))
      reversed.insert(reversed.end(), data.begin() + static_cast<std::ptrdiff_t>(i) - d,
                      data.begin() + static_cast<std::ptrdiff_t>(i));
    for (const auto& kernel : fitting_kernels(d)) {
      const auto one = kernel.fit(data, 0.01, {});
      const auto other = kernel.fit(reversed, 0.01, {});
      ASSERT_EQ(one.segments(d), other.segments(d)) << kernel.info->id << " trial " << trial;
      const int last = 4 * one.segments(d) - 1;
      for (int j = 0; j <= last; ++j)
        for (int axis = 0; axis < d; ++axis)
          EXPECT_NEAR(coordinate(one, d, 0, j, axis), coordinate(other, d, 0, last - j, axis), 1e-6)
              << kernel.info->id << " trial " << trial;
    }
  }
}

/// The sides of a square, twelve points each: only its corners are joints, also where closed data begin.
TEST(Fitting, KeepsCorners) {
  Data square{0, 0};
  const std::vector<std::array<double, 2>> ways{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (const auto& [x, y] : ways)
    for (int k = 0; k < 12; ++k) {
      square.push_back(square[square.size() - 2] + x);
      square.push_back(square[square.size() - 2] + y);
    }
  for (const auto& kernel : fitting_kernels(2))
    for (const double tolerance : {1e-6, 0.25, 1.0}) {
      const auto fit = kernel.fit(square, tolerance, {});
      ASSERT_EQ(fit.segments(2), 4) << kernel.info->id << " " << tolerance;
      for (int s = 0; s < 4; ++s) EXPECT_NEAR(cosine_at_joint(fit, 2, s, (s + 1) % 4), 0, 1e-9) << kernel.info->id;
    }
}

/// Noise of half the tolerance is not a corner.
TEST(Fitting, SeesNoCornersInNoise) {
  Inputs inputs(5);
  Data line;
  for (int k = 0; k < 200; ++k) {
    line.push_back(k * 0x1p-6 + 0x1p-9 * inputs.symmetric());
    line.push_back(0x1p-7 * inputs.symmetric());
  }
  for (const auto& kernel : fitting_kernels(2)) {
    const auto fit = kernel.fit(line, 0x1p-5, {});
    for (int s = 1; s < fit.segments(2); ++s) EXPECT_GT(cosine_at_joint(fit, 2, s - 1, s), 1 - 1e-9) << kernel.info->id;
  }
}

/// Smooth data have no inner corners; in closed data the joint of the ends is not a corner either.
TEST(Fitting, JoinsSmoothly) {
  Data circle;  // by the rational parametrisation, counted all the way round
  for (int k = 0; k <= 64; ++k) {
    const double u = (k % 32 - 16) / 16.0;  // a half circle per 32 steps
    const double sign = k % 64 < 32 ? 1 : -1;
    circle.push_back(sign * 2 * u / (1 + u * u));
    circle.push_back(-sign * (1 - u * u) / (1 + u * u));
  }
  for (const auto& kernel : fitting_kernels(2))
    for (const double tolerance : {1e-2, 1e-4, 1e-7}) {
      const auto fit = kernel.fit(circle, tolerance, {});
      const int segments = fit.segments(2);
      EXPECT_GT(segments, 1);
      for (int s = 0; s < segments; ++s)
        EXPECT_GT(cosine_at_joint(fit, 2, s, (s + 1) % segments), 1 - 1e-12)
            << kernel.info->id << " joint " << s << " of " << segments;
    }
}

TEST(Fitting, TwoPointsMakeAStraightSegmentAndOnePointASegmentOfOnePoint) {
  for (const auto& kernel : fitting_kernels(2)) {
    EXPECT_THAT(kernel.fit(Data{1, 2, 4, 8}, 0, {}).control_points, testing::ElementsAre(1, 2, 2, 4, 3, 6, 4, 8));
    EXPECT_THAT(kernel.fit(Data{1, 2, 1, 2, 4, 8, 4, 8}, 0, {}).control_points,
                testing::ElementsAre(1, 2, 2, 4, 3, 6, 4, 8));
    EXPECT_THAT(kernel.fit(Data{1, 2, 1, 2}, 0, {}).control_points, testing::ElementsAre(1, 2, 1, 2, 1, 2, 1, 2));
    EXPECT_THAT(kernel.fit(Data{1, 2}, 0, {}).t, testing::ElementsAre(0));
  }
}

TEST(Fitting, ALineIsOneStraightSegment) {
  Inputs inputs(6);
  Data line;
  double x = 0;
  for (int k = 0; k < 50; ++k, x += std::floor(1 + 30 * inputs.unit())) line.insert(line.end(), {3 * x, -x, 2 * x});
  for (const auto& kernel : fitting_kernels(3)) {
    const auto fit = kernel.fit(line, 1e-9, {});
    EXPECT_EQ(fit.segments(3), 1) << kernel.info->id;
    EXPECT_GT(cosine_at_joint(fit, 3, 0, 0), 1 - 1e-12) << kernel.info->id;
  }
}

/// The data run forth and back on a line: there is a corner where they turn.
TEST(Fitting, TurnsBackInACorner) {
  Data data;
  for (const double x : {0, 1, 2, 3, 4, 3, 2, 1}) data.insert(data.end(), {x, 2 * x});
  for (const auto& kernel : fitting_kernels(2)) {
    const auto fit = kernel.fit(data, 1e-9, {});
    EXPECT_EQ(fit.segments(2), 2) << kernel.info->id;
    EXPECT_EQ(coordinate(fit, 2, 0, 3, 0), 4) << kernel.info->id;
  }
}

/// Different points that scaling makes equal.
TEST(Fitting, PointsThatScalingMakesOne) {
  const Data data{1e308, 0, 1e308, 5e-324, 1e308, 1e-323, 1e308, 0};
  for (const auto& kernel : fitting_kernels(2))
    for (const double tolerance : {0.0, 1.0, 1e300}) {
      const auto fit = kernel.fit(data, tolerance, {});
      EXPECT_TRUE(fit.converged);
      EXPECT_LE(fit.max_error, tolerance);
      for (const double t : fit.t) EXPECT_TRUE(t >= 0 && t <= 1) << kernel.info->id;
    }
}

/// The curve runs from 0 to a quarter of the way, back beyond the start and to it again: three straight parts, whatever
/// the steps of the data and the arms for corners.
TEST(Fitting, TurnsBackAtTheTips) {
  auto data = samples({0, 0, 1, 2, -1, -2, 0, 0}, 2, 40);
  for (const auto& kernel : fitting_kernels(2))
    for (const double tolerance : {0.1, 0.03, 0.01, 1e-6})
      EXPECT_EQ(kernel.fit(data, tolerance, {}).segments(2), 3) << kernel.info->id << " " << tolerance;
}

/// A fit whose handles overflow does not report convergence.
TEST(Fitting, OverflowIsNotConvergence) {
  const double most = std::numeric_limits<double>::max();
  const Data data{-most, 0, most, 0.5 * most, -most, most, most, -most};
  for (const auto& kernel : fitting_kernels(2)) {
    const auto fit = kernel.fit(data, 0, {});
    EXPECT_EQ(fit.converged, std::ranges::all_of(fit.control_points, [](double x) { return std::isfinite(x); }));
  }
}

reference::Departure departure_of(const Fit& fit, int d, const Data& data, double tolerance) {
  std::vector<reference::NearPlace> places;
  for (std::size_t i = 0; i < fit.t.size(); ++i) places.push_back({fit.segment[i], fit.t[i]});
  return reference::departure_from_polyline(d, data, fit.control_points, places, tolerance);
}

TEST(Fitting, StaysNearThePolylineOfTheData) {
  const auto expect_near = [](const Data& data, int d, double tolerance, const auto& where) {
    for (const auto& kernel : fitting_kernels(d)) {
      const auto found = departure_of(kernel.fit(data, tolerance, {}), d, data, tolerance);
      EXPECT_LE(found.over_limit, 1) << kernel.info->id << " " << where << " tolerance " << tolerance;
      EXPECT_LE(found.handle, 3 * (1 + 1e-12)) << kernel.info->id << " " << where << " tolerance " << tolerance;
    }
  };
  Inputs inputs(7);
  for (int trial = 0; trial < 240; ++trial)
    for (const double tolerance : {0.0, 1e-9, 1e-3, 0.03, 0.1, 10.0}) {
      const int d = 1 + trial % 3;
      expect_near(any_data(inputs, trial, d), d, tolerance, trial);
    }
  for (int trial = 0; trial < 100; ++trial) {  // polygons with sides of very different lengths
    Data polygon;
    for (int k = 0; k < 8; ++k) {
      const double size = k % 2 == 0 ? 1 : 0x1p-6;
      polygon.push_back((k < 2 ? 0 : polygon[static_cast<std::size_t>(2 * k - 2)]) + size * inputs.symmetric());
      polygon.push_back((k < 2 ? 0 : polygon[static_cast<std::size_t>(2 * k - 1)]) + size * inputs.symmetric());
    }
    for (const double tolerance : {1e-6, 1e-2, 0.1}) expect_near(polygon, 2, tolerance, trial);
  }
}

/// A line of pixels is within half a pixel of a straight line, so within one of the straight line between its ends.
TEST(Fitting, KeepsStraightDataStraight) {
  Inputs inputs(8);
  for (int trial = 0; trial < 100; ++trial) {
    const double x = 100 * inputs.symmetric();
    const double y = 100 * inputs.symmetric();
    const int count = 3 + trial;
    Data line;
    for (int k = 0; k < count; ++k)
      for (const double end : {x, y}) line.push_back(std::floor(end * k / (count - 1) + 0.5));
    for (const auto& kernel : fitting_kernels(2)) {
      const auto fit = kernel.fit(line, 1.5, {});
      ASSERT_EQ(fit.segments(2), 1) << kernel.info->id << " " << trial;
      for (int axis = 0; axis < 2; ++axis) {
        const double first = coordinate(fit, 2, 0, 0, axis);
        const double third = (coordinate(fit, 2, 0, 3, axis) - first) / 3;
        EXPECT_NEAR(coordinate(fit, 2, 0, 1, axis), first + third, 1e-12);
        EXPECT_NEAR(coordinate(fit, 2, 0, 2, axis), first + 2 * third, 1e-12);
      }
    }
  }
}

/// The cosine of the angle between the first or the last side of the control polygon and a direction.
double cosine_at_end(const Fit& fit, bool start, const Data& direction) {
  const int segment = start ? 0 : fit.segments(2) - 1;
  double product = 0, square = 0, other = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double side =
        coordinate(fit, 2, segment, start ? 1 : 3, axis) - coordinate(fit, 2, segment, start ? 0 : 2, axis);
    product += side * direction[static_cast<std::size_t>(axis)];
    square += side * side;
    other += direction[static_cast<std::size_t>(axis)] * direction[static_cast<std::size_t>(axis)];
  }
  return product / std::sqrt(square * other);
}

TEST(Fitting, BeginsAndEndsInGivenDirections) {
  const auto arch = samples({0, 0, 1, 2, 3, 2, 4, 0}, 2, 20);
  Data closed = arch;
  closed.insert(closed.end(), arch.begin(), arch.begin() + 2);
  const Data start{0, 3};
  const Data end{1e-200, -1e-200};
  for (const auto& kernel : fitting_kernels(2))
    for (const auto& data : {arch, closed, Data{0, 0, 4, 0}})
      for (const double tolerance : {1e-6, 0.1, 10.0}) {
        const auto fit = kernel.fit(data, tolerance, {start, end});
        EXPECT_LE(fit.max_error, tolerance);
        EXPECT_NEAR(cosine_at_end(fit, true, {0, 1}), 1, 1e-12) << kernel.info->id << " " << tolerance;
        EXPECT_NEAR(cosine_at_end(fit, false, {1, -1}), 1, 1e-12) << kernel.info->id << " " << tolerance;
      }
}

/// Handles across the chord leave it by at least 4/9 of their length, so at a tolerance of 2^-40 of the chord none that
/// is halved 30 times is short enough: the tolerance comes before the direction, and the segment is straight.
TEST(Fitting, IsStraightWhereNoHandleKeepsTheTolerance) {
  for (const auto& kernel : fitting_kernels(2)) {
    const auto fit = kernel.fit(Data{0, 0, 3, 0}, 0x1p-40, {Data{0, 1}, Data{0, -1}});
    ASSERT_EQ(fit.control_points.size(), 8U) << kernel.info->id;
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(fit.control_points[2 * j], static_cast<double>(j), 1e-15) << kernel.info->id;
      EXPECT_EQ(fit.control_points[2 * j + 1], 0) << kernel.info->id;
    }
  }
}

const Data gentle{0, 0, 1, 2, 3, 3, 4, 0};

/// Samples of a cubic give that cubic: what users expect first of a fit.
TEST(GaussNewton, ReproducesItsOwnSource) {
  for (const double factor : {1e-9, 1.0, 1e10}) {
    Data control = gentle;
    for (double& x : control) x *= factor;
    for (const int count : {8, 33, 500, 514, 5000}) {
      const auto fit = fitting_kernels(2)[1].fit(samples(control, 2, count), 1e-9 * factor, {});
      ASSERT_EQ(fitting_kernels(2)[1].info->id, "gauss_newton");
      ASSERT_EQ(fit.segments(2), 1) << count;
      for (std::size_t k = 0; k < control.size(); ++k)
        EXPECT_NEAR(fit.control_points[k], control[k], 1e-12 * factor) << count;
      EXPECT_LT(fit.max_error, 1e-13 * factor);
    }
  }
}

/// A fit of many points begins with a sample of them, but keeps the tolerance at every point.
TEST(GaussNewton, SeesEveryOneOfManyPoints) {
  for (const std::size_t count : {513U, 514U, 5000U}) {
    auto data = samples(gentle, 2, static_cast<int>(count));
    data[2 * (count / 3) + 1] += 1e-3;
    const auto fit = fitting_kernels(2)[1].fit(data, 1e-4, {});
    ASSERT_EQ(fitting_kernels(2)[1].info->id, "gauss_newton");
    EXPECT_GT(fit.segments(2), 1) << count;
    EXPECT_EQ(fit.t.size(), count);
    EXPECT_LE(fit.max_error, 1e-4) << count;
  }
}

TEST(Schneider, DoesNotReproduceItsOwnSource) {
  const auto fit = fitting_kernels(2)[0].fit(samples(gentle, 2, 33), 1e-9, {});
  ASSERT_EQ(fitting_kernels(2)[0].info->id, "schneider");
  EXPECT_GT(fit.segments(2), 16);
}

}  // namespace
}  // namespace bezierbench
