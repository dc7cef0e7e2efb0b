// SPDX-License-Identifier: MIT
// B-spline curves by the C interface, and those that it must refuse.
#include <bezierbench/bezierbench.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

/// The curve that `make` makes, freed with the test.
template <class Make>
std::shared_ptr<bb_bspline_made> made(const Make& make) {
  bb_bspline_made* curve = nullptr;
  EXPECT_EQ(make(&curve), BB_OK);
  return {curve, bb_bspline_free};
}

std::vector<double> points_of(const std::shared_ptr<bb_bspline_made>& curve) {
  bb_bspline view{};
  EXPECT_EQ(bb_bspline_get(curve.get(), &view), BB_OK);
  return {view.points, view.points + view.count * static_cast<std::size_t>(view.dimension)};
}

std::vector<double> knots_of(const std::shared_ptr<bb_bspline_made>& curve) {
  bb_bspline view{};
  EXPECT_EQ(bb_bspline_get(curve.get(), &view), BB_OK);
  return {view.knots, view.knots + view.count + static_cast<std::size_t>(view.degree) + 1};
}

/// The uniform quadratic of [Piegl and Tiller 1997] goes through the middles of its control polygon at its knots.
TEST(BsplineInC, MakesTheSameCurveInOtherWays) {
  constexpr std::array points{0.0, 4.0, 12.0, 2.0};
  constexpr std::array knots{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const bb_bspline curve{1, 2, 4, points.data(), nullptr, knots.data()};
  constexpr std::array t{2.0, 3.0, 4.0};
  std::array<double, 3> values{};
  for (const char* method : {static_cast<const char*>(nullptr), "de_boor", "chudy_wozny_span"}) {
    ASSERT_EQ(bb_bspline_evaluate(method, &curve, t.data(), t.size(), values.data()), BB_OK);
    EXPECT_THAT(values, testing::ElementsAre(2, 8, 7));
  }
  ASSERT_EQ(bb_bspline_exact(&curve, t.data(), t.size(), values.data()), BB_OK);
  EXPECT_THAT(values, testing::ElementsAre(2, 8, 7));
  bb_curves* spans = nullptr;
  ASSERT_EQ(bb_bspline_spans(&curve, &spans), BB_OK);
  ASSERT_EQ(bb_curves_count(spans), 2U);
  bb_curve second{};
  ASSERT_EQ(bb_curves_at(spans, 1, &second), BB_OK);
  EXPECT_THAT(std::vector(second.points, second.points + 3), testing::ElementsAre(8, 12, 7));
  bb_curves_free(spans);

  constexpr std::array ends{2.0, 2.0, 3.0, 4.0, 4.0};
  const auto clamped = made([&](auto** to) { return bb_bspline_insert(&curve, ends.data(), ends.size(), to); });
  EXPECT_THAT(points_of(clamped), testing::ElementsAre(2, 4, 8, 12, 7));
  EXPECT_THAT(knots_of(clamped), testing::ElementsAre(2, 2, 2, 3, 3, 4, 4, 4));
  bb_bspline view{};
  ASSERT_EQ(bb_bspline_get(clamped.get(), &view), BB_OK);
  double deviation = -1;
  const auto back = made([&](auto** to) { return bb_bspline_remove(&view, &t[1], 1, to, &deviation); });
  EXPECT_THAT(points_of(back), testing::ElementsAre(2, 4, 12, 7));
  EXPECT_EQ(deviation, 0);
  EXPECT_THAT(points_of(made([&](auto** to) { return bb_bspline_part(&curve, 3, 4, to); })),
              testing::ElementsAre(8, 12, 7));
  EXPECT_THAT(points_of(made([&](auto** to) { return bb_bspline_derivative(&curve, 1, to); })),
              testing::ElementsAre(4, 8, -10));
  const auto cubic = made([&](auto** to) { return bb_bspline_elevate(&view, 3, to); });
  EXPECT_THAT(points_of(cubic), testing::ElementsAre(2, 10.0 / 3, 16.0 / 3, 8, 32.0 / 3, 31.0 / 3, 7));
}

TEST(BsplineInC, WhatIsWrongIsRefused) {
  constexpr std::array points{0.0, 4.0, 12.0};
  constexpr std::array knots{0.0, 0.0, 1.0, 2.0, 2.0};
  constexpr std::array weights{1.0, 0.0, 1.0};
  const bb_bspline line{1, 1, 3, points.data(), nullptr, knots.data()};
  bb_bspline_made* to = nullptr;
  double value = 0;
  constexpr std::array once{1.0};
  constexpr std::array outside{2.5};
  EXPECT_EQ(bb_bspline_evaluate("horner", &line, once.data(), 1, &value), BB_ERROR_METHOD);
  EXPECT_EQ(bb_bspline_evaluate(nullptr, &line, outside.data(), 1, &value), BB_ERROR_PARAMETER);
  EXPECT_EQ(bb_bspline_insert(&line, once.data(), 1, &to), BB_ERROR_COUNT);
  EXPECT_EQ(bb_bspline_insert(&line, outside.data(), 1, &to), BB_ERROR_PARAMETER);
  EXPECT_EQ(bb_bspline_remove(&line, knots.data(), 1, &to, &value), BB_ERROR_COUNT);
  EXPECT_EQ(bb_bspline_remove(&line, once.data(), 1, &to, nullptr), BB_ERROR_NULL);
  EXPECT_EQ(bb_bspline_elevate(&line, 0, &to), BB_ERROR_DEGREE);
  EXPECT_EQ(bb_bspline_elevate(&line, 65, &to), BB_ERROR_DEGREE);  // documented: at most 64
  EXPECT_EQ(bb_bspline_part(&line, 1, 1, &to), BB_ERROR_PARAMETER);
  EXPECT_EQ(bb_bspline_part(&line, 0, 1, nullptr), BB_ERROR_NULL);
  EXPECT_EQ(bb_bspline_derivative(&line, 1, &to), BB_ERROR_PARAMETER);
  const auto with = [&](auto change) {
    bb_bspline other = line;
    change(other);
    return bb_bspline_elevate(&other, 2, &to);
  };
  EXPECT_EQ(with([&](auto& b) { b.weights = weights.data(); }), BB_ERROR_NO_POINT);
  EXPECT_EQ(with([&](auto& b) { b.count = 1; }), BB_ERROR_COUNT);
  EXPECT_EQ(with([&](auto& b) { b.degree = 0; }), BB_ERROR_DEGREE);
  EXPECT_EQ(with([&](auto& b) { b.knots = nullptr; }), BB_ERROR_NULL);
  EXPECT_EQ(with([&](auto& b) { b.dimension = 4; }), BB_ERROR_DIMENSION);
  constexpr std::array descending{0.0, 0.0, 1.0, 0.5, 2.0};
  EXPECT_EQ(with([&](auto& b) { b.knots = descending.data(); }), BB_ERROR_PARAMETER);
  EXPECT_EQ(to, nullptr);
}

}  // namespace
