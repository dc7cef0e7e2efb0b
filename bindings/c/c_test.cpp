// SPDX-License-Identifier: MIT
// The C interface against the definitions and the reference, and everything that it must refuse.
#include <bezierbench/bezierbench.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <vector>
#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// (0,0) (1,2) (3,0.1): 2t + t^2, 4t - 3.9 t^2 except for the rounding of 0.1.
constexpr std::array parabola_points{0.0, 0.0, 1.0, 2.0, 3.0, 0.1};
constexpr bb_curve parabola{BB_BERNSTEIN, 2, 2, parabola_points.data(), nullptr};
constexpr std::array rational_weights{1.0, 0.5, 1.0};
constexpr bb_curve rational_parabola{BB_RATIONAL, 2, 2, parabola_points.data(), rational_weights.data()};
/// A quarter of the unit circle by t = tan(phi / 2), and a curve with a pole at 1/2.
constexpr std::array<double, 6> corner{1, 0, 1, 1, 0, 1};
constexpr std::array<double, 3> growing{1, 1, 2};
constexpr std::array<double, 3> cancelling{1, -1, 1};
constexpr bb_curve circle{BB_RATIONAL, 2, 2, corner.data(), growing.data()};
constexpr bb_curve pole{BB_RATIONAL, 2, 2, corner.data(), cancelling.data()};
constexpr std::array parameters{0.0, 0.25, 0.5, 0.875, 1.0};
constexpr auto parameter_count = parameters.size();

std::vector<bb_method> methods(const std::string& problem) {
  std::vector<bb_method> result;
  for (std::size_t i = 0; i < bb_method_count(); ++i) {
    bb_method method;
    EXPECT_EQ(bb_method_at(i, &method), BB_OK);
    if (method.problem == problem) result.push_back(method);
  }
  return result;
}

std::string exact_text(const bb_curve& curve, double t, int axis) {
  std::size_t required = 0;
  EXPECT_EQ(bb_curve_exact_text(&curve, t, axis, nullptr, 0, &required), BB_ERROR_COUNT);
  std::string text(required, '?');
  EXPECT_EQ(bb_curve_exact_text(&curve, t, axis, text.data(), required - 1, nullptr), BB_ERROR_COUNT);
  EXPECT_EQ(bb_curve_exact_text(&curve, t, axis, text.data(), required, nullptr), BB_OK);
  EXPECT_EQ(text.back(), '\0');
  text.pop_back();
  return text;
}

TEST(C, EveryMethodIsWithinItsBound) {
  const std::array forms{parabola, bb_curve{BB_POWER, 2, 2, parabola_points.data(), nullptr}, rational_parabola};
  int judged = 0;
  for (const auto& method : methods("evaluation")) {
    const auto& curve = forms[static_cast<std::size_t>(method.form)];
    std::array<double, 2 * parameter_count> values{};
    ASSERT_EQ(bb_curve_evaluate(method.id, &curve, parameters.data(), parameter_count, values.data()), BB_OK)
        << method.id;
    std::array<bb_error, 2 * parameter_count> errors{};
    ASSERT_EQ(bb_curve_error(&curve, parameters.data(), parameter_count, values.data(), errors.data()), BB_OK);
    std::array<bb_bound, 2 * parameter_count> bounds{};
    const int status = bb_curve_bound(method.id, &curve, parameters.data(), parameter_count, bounds.data());
    if (*method.bound == '\0') {
      EXPECT_EQ(status, BB_ERROR_NO_BOUND) << method.id;
      continue;
    }
    ASSERT_EQ(status, BB_OK) << method.id;
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_LE(errors[i].error, bounds[i].bound) << method.id;
    ++judged;
  }
  EXPECT_GT(judged, 20);
}

TEST(C, ExactPointsAreRoundedOnce) {
  std::array<double, 2 * parameter_count> exact{};
  ASSERT_EQ(bb_exact(2, 2, parabola_points.data(), parameters.data(), parameter_count, exact.data()), BB_OK);
  for (std::size_t i = 0; i < parameter_count; ++i) {
    const long double t = parameters[i];  // of few bits, so that these sums are exact in long double
    EXPECT_EQ(exact[2 * i], static_cast<double>(2 * t + t * t));
    EXPECT_EQ(exact[2 * i + 1], static_cast<double>(4 * t * (1 - t) + t * t * parabola_points[5]));
  }
  EXPECT_EQ(exact_text(parabola, 0.5, 0), "5/4");
  EXPECT_EQ(exact_text(rational_parabola, 0.5, 0), "4/3");  // (0 + 2/2 1 + 3) / (1 + 2/2 + 1)
  EXPECT_EQ(exact_text(parabola, 1, 0), "3");
  EXPECT_EQ(exact_text(parabola, -1, 0), "-1");
}

TEST(C, ErrorsAreInEveryUnit) {
  const double t = 0.5;
  const std::array values{1.25 + 0x1p-52, not_a_number};
  std::array<bb_error, 2> errors{};
  ASSERT_EQ(bb_curve_error(&parabola, &t, 1, values.data(), errors.data()), BB_OK);
  EXPECT_EQ(errors[0].exact, 1.25);
  EXPECT_EQ(errors[0].error, 0x1p-52);
  EXPECT_EQ(errors[0].error_ulp, 1);
  EXPECT_EQ(errors[0].error_u, 2 / 1.25);
  EXPECT_EQ(errors[1].error, infinity);
}

TEST(C, LengthsOfALineAreItsPart) {
  constexpr std::array<double, 4> ends{0, 0, 3, 4};
  const bb_curve line{BB_BERNSTEIN, 2, 1, ends.data(), nullptr};
  double exact = 0;
  double error = 1;
  ASSERT_EQ(bb_exact_arc_length(&line, 0.25, 0.75, &exact), BB_OK);
  EXPECT_EQ(exact, 2.5);
  ASSERT_EQ(bb_arc_length_error(&line, 0.25, 0.75, 2.5, &error), BB_OK);
  EXPECT_EQ(error, 0);
  ASSERT_EQ(bb_arc_length_error(&line, 0.25, 0.75, 2, &error), BB_OK);
  EXPECT_EQ(error, 0.5);
  for (const auto& method : methods("arc_length")) {
    bb_length length{};
    ASSERT_EQ(bb_arc_length(method.id, &line, 0.25, 0.75, 1e-9, &length), BB_OK) << method.id;
    EXPECT_NEAR(length.length, 2.5, 1e-8) << method.id;
    EXPECT_GT(length.evaluations, 0);
  }
}

/// Half of a quarter circle, to t = tan(pi / 8).
TEST(C, LengthsOfARationalCurve) {
  constexpr double pi = 3.141592653589793;
  double exact = 0;
  ASSERT_EQ(bb_exact_arc_length(&circle, 0, 1, &exact), BB_OK);
  EXPECT_EQ(exact, pi / 2);
  EXPECT_EQ(bb_exact_arc_length(&pole, 0, 1, &exact), BB_ERROR_NO_POINT);
  EXPECT_EQ(bb_exact_arc_length(&pole, 0.75, 1, &exact), BB_OK);
  for (const auto& method : methods("arc_length")) {
    if (method.form != BB_RATIONAL) continue;
    bb_length length{};
    ASSERT_EQ(bb_arc_length(method.id, &circle, 0, 0.4142135623730951, 1e-9, &length), BB_OK) << method.id;
    EXPECT_NEAR(length.length, pi / 4, 1e-3) << method.id;
    EXPECT_EQ(bb_arc_length(method.id, &pole, 0, 1, 1e-9, &length), BB_ERROR_NO_POINT);
  }
  for (const auto& method : methods("inverse_arc_length")) {
    if (method.form != BB_RATIONAL) continue;
    bb_parameter found{};
    ASSERT_EQ(bb_at_length(method.id, &circle, pi / 4, 1e-9, &found), BB_OK) << method.id;
    EXPECT_NEAR(found.t, 0.4142135623730951, 1e-8) << method.id;
    EXPECT_EQ(bb_at_length(method.id, &pole, 0, 1e-9, &found), BB_ERROR_NO_POINT);
  }
}

TEST(C, TheFootOfAPointOverAQuarterCircle) {
  constexpr std::array<double, 2> point{3, 4};
  double t = 0;
  double distance = 0;
  ASSERT_EQ(bb_exact_project(&circle, point.data(), &t, &distance), BB_OK);
  EXPECT_EQ(t, 0.5);
  EXPECT_EQ(distance, 4);
  EXPECT_EQ(bb_exact_project(&pole, point.data(), &t, &distance), BB_ERROR_NO_POINT);
  for (const auto& method : methods("projection")) {
    if (method.form != BB_RATIONAL) continue;
    bb_foot foot{};
    ASSERT_EQ(bb_project(method.id, &circle, point.data(), &foot), BB_OK) << method.id;
    EXPECT_NEAR(foot.t, 0.5, 1e-14) << method.id;
    EXPECT_EQ(bb_project(method.id, &pole, point.data(), &foot), BB_ERROR_NO_POINT);
  }
}

TEST(C, TheFootOfAPointOverALine) {
  constexpr std::array<double, 4> ends{0, 0, 4, 0};
  const bb_curve line{BB_BERNSTEIN, 2, 1, ends.data(), nullptr};
  constexpr std::array<double, 2> point{1, 3};
  double t = 0;
  double distance = 0;
  ASSERT_EQ(bb_exact_project(&line, point.data(), &t, &distance), BB_OK);
  EXPECT_EQ(t, 0.25);
  EXPECT_EQ(distance, 3);
  double error = 0;
  ASSERT_EQ(bb_project_error(&line, point.data(), 0.25, 3.5, &error), BB_OK);
  EXPECT_EQ(error, 0.5);
  int found = 0;
  for (const auto& method : methods("projection")) {
    bb_foot foot{};
    const int status = bb_project(method.id, &line, point.data(), &foot);
    if (status == BB_ERROR_DEGREE) continue;
    ASSERT_EQ(status, BB_OK) << method.id;
    const double printed_tolerance = 1e-4;  // of the method that has it
    EXPECT_NEAR(foot.t, 0.25, std::string_view(method.id) == "seed_004_scan" ? printed_tolerance : 1e-6) << method.id;
    EXPECT_NEAR(foot.distance, 3, 1e-6) << method.id;
    ++found;
  }
  EXPECT_GT(found, 1);
}

TEST(C, AFitIsAsNearAsItSays) {
  std::vector<double> data;
  for (int i = 0; i <= 40; ++i) data.insert(data.end(), {std::cos(0.1 * i), std::sin(0.1 * i)});
  for (const auto& method : methods("fitting")) {
    bb_fitted* fitted = nullptr;
    ASSERT_EQ(bb_fit(method.id, 2, data.data(), data.size() / 2, 1e-3, &fitted), BB_OK);
    ASSERT_GT(bb_fitted_segments(fitted), 0U);
    EXPECT_EQ(bb_fitted_points(fitted)[0], data[0]);
    EXPECT_EQ(bb_fitted_points(fitted)[8 * bb_fitted_segments(fitted) - 1], data.back());
    double error = infinity;
    EXPECT_EQ(bb_fitted_exact_error(fitted, &error), BB_OK);
    EXPECT_LE(error, bb_fitted_max_error(fitted));
    EXPECT_LE(bb_fitted_max_error(fitted), 1e-3);
    bb_fitted_free(fitted);
  }
  bb_fitted_free(nullptr);
  bb_fitted* none = nullptr;
  EXPECT_EQ(bb_fit("schneider", 2, data.data(), 1, 1e-3, &none), BB_ERROR_COUNT);
  EXPECT_EQ(bb_fit("schneider", 2, data.data(), 2, -1, &none), BB_ERROR_TOLERANCE);
  EXPECT_EQ(bb_fit("horner", 2, data.data(), 2, 0, &none), BB_ERROR_METHOD);
  const std::vector<double> nowhere{0, 0};
  EXPECT_EQ(bb_fit_directed("schneider", 2, data.data(), 2, 0, nullptr, nowhere.data(), &none), BB_ERROR_PARAMETER);
  EXPECT_EQ(none, nullptr);
}

TEST(C, AFitBeginsAndEndsAsAsked) {
  const std::vector<double> arch{0, 0, 1, 1, 2, 1, 3, 0};
  const std::vector<double> up{0, 5};
  const std::vector<double> down{0, -2};
  bb_fitted* fitted = nullptr;
  ASSERT_EQ(bb_fit_directed("gauss_newton", 2, arch.data(), 4, 0.1, up.data(), down.data(), &fitted), BB_OK);
  const double* b = bb_fitted_points(fitted);
  const double* last = b + 8 * bb_fitted_segments(fitted) - 4;
  EXPECT_EQ(b[2], 0);
  EXPECT_GT(b[3], 0);
  EXPECT_EQ(last[0], 3);
  EXPECT_GT(last[1], 0);
  bb_fitted_free(fitted);
}

/// 0, 1, 0, 1: 5/9, 8/9, -1/9 and 10/9, 1/9, 4/9, by hand from the system of equal steps, which centripetal ones are here.
TEST(C, ASplineMeetsItsPoints) {
  const std::vector<double> k{0, 1, 0, 1};
  const std::vector<double> ninths{0, 5, 10, 9, 9, 8, 1, 0, 0, -1, 4, 9};
  std::vector<double> segments(12, infinity);
  ASSERT_EQ(bb_interpolate(nullptr, 1, k.data(), 4, segments.data()), BB_OK);
  for (std::size_t i = 0; i < ninths.size(); ++i) EXPECT_NEAR(segments[i], ninths[i] / 9, 1e-15);
  const std::vector<double> line{0, 1, 100};
  const bb_spline chord{BB_CHORD, BB_NATURAL, 0, nullptr, nullptr};
  ASSERT_EQ(bb_interpolate(&chord, 1, line.data(), 3, segments.data()), BB_OK);
  EXPECT_NEAR(segments[5], 34, 1e-12);
  const std::vector<double> square{0, 1, 4};  // t^2, whose derivatives at 0 and 2 are 0 and 4
  const double start = 0;
  const double end = 4;
  for (const bb_spline& spline : {bb_spline{BB_UNIFORM, BB_CLAMPED, 0, &start, &end},
                                  bb_spline{BB_UNIFORM, BB_NOT_A_KNOT, 0, nullptr, nullptr}}) {
    ASSERT_EQ(bb_interpolate(&spline, 1, square.data(), 3, segments.data()), BB_OK);
    EXPECT_NEAR(segments[6], 8.0 / 3, 1e-14);
  }
  const std::vector<double> corners{0, 0, 1, 0, 1, 1, 0, 1};
  std::vector<double> closed(4 * 4 * 2, infinity);
  const bb_spline ring{BB_CHORD, BB_CLOSED, 0, nullptr, nullptr};
  ASSERT_EQ(bb_interpolate(&ring, 2, corners.data(), 4, closed.data()), BB_OK);
  EXPECT_NEAR(closed[2], 0.25, 1e-15);  // slopes by symmetry: 4 m_0 + m_1 + m_3 = 3 (K_1 - K_3)
  EXPECT_EQ(closed[30], 0);
}

TEST(C, ASplineThatCannotBeIsRefused) {
  std::vector<double> k{0, 0, 1};
  std::vector<double> segments(8, 7);
  const auto status = [&](const bb_spline& spline) {
    return bb_interpolate(&spline, 1, k.data(), k.size(), segments.data());
  };
  EXPECT_EQ(status({}), BB_ERROR_REPEATED);
  EXPECT_EQ(status({3, 0, 0, nullptr, nullptr}), BB_ERROR_PARAMETER);
  EXPECT_EQ(status({0, 4, 0, nullptr, nullptr}), BB_ERROR_PARAMETER);
  EXPECT_EQ(status({BB_UNIFORM, BB_CLAMPED, 0, nullptr, nullptr}), BB_ERROR_NULL);
  EXPECT_EQ(bb_interpolate(nullptr, 1, k.data(), 1, segments.data()), BB_ERROR_COUNT);
  EXPECT_EQ(bb_interpolate(nullptr, 4, k.data(), 3, segments.data()), BB_ERROR_DIMENSION);
  EXPECT_EQ(bb_interpolate(nullptr, 1, k.data(), 3, nullptr), BB_ERROR_NULL);
  k = {1.7e308, 1.7e308, -1.7e308};  // a parabola with its vertex above
  EXPECT_EQ(status({BB_UNIFORM, BB_NOT_A_KNOT, 0, nullptr, nullptr}), BB_ERROR_OVERFLOW);
  EXPECT_EQ(segments, std::vector<double>(8, 7));
  EXPECT_EQ(status({BB_UNIFORM, BB_NATURAL, 1, nullptr, nullptr}), BB_OK);  // monotone stays within the points
}

TEST(C, FilesOfCurvesAreRead) {
  const std::string file = testing::TempDir() + "bezierbench_c_test.svg";
  const auto write = [&](const std::string& text) { std::ofstream(file) << text; };
  write("<svg><path id='a' d='M0,0 L1,2 q1,1 2,0'/><circle r='2'/></svg>");
  bb_curves* curves = nullptr;
  std::array<char, 100> message{};
  ASSERT_EQ(bb_curves_read(file.c_str(), message.data(), message.size(), &curves), BB_OK);
  ASSERT_EQ(bb_curves_count(curves), 6);
  bb_curve curve;
  ASSERT_EQ(bb_curves_at(curves, 1, &curve), BB_OK);
  EXPECT_EQ(std::vector(curve.points, curve.points + 6), (std::vector<double>{1, 2, 2, 3, 3, 2}));
  EXPECT_EQ(curve.weights, nullptr);
  ASSERT_EQ(bb_curves_at(curves, 2, &curve), BB_OK);
  EXPECT_EQ(curve.form, BB_RATIONAL);
  EXPECT_EQ(curve.weights[1], std::sqrt(0.5));
  int begins = -1;
  ASSERT_EQ(bb_curves_begins_path(curves, 1, &begins), BB_OK);
  EXPECT_EQ(begins, 0);
  ASSERT_EQ(bb_curves_begins_path(curves, 2, &begins), BB_OK);
  EXPECT_EQ(begins, 1);
  std::array<char, 6> id{};
  std::size_t required = 0;
  EXPECT_EQ(bb_curves_id(curves, 1, id.data(), 5, &required), BB_ERROR_COUNT);
  EXPECT_EQ(required, 6);
  ASSERT_EQ(bb_curves_id(curves, 1, id.data(), id.size(), nullptr), BB_OK);
  EXPECT_STREQ(id.data(), "a:0:1");
  EXPECT_EQ(bb_curves_at(curves, 6, &curve), BB_ERROR_COUNT);
  EXPECT_EQ(bb_curves_at(nullptr, 0, &curve), BB_ERROR_NULL);
  bb_curves_free(curves);
  bb_curves_free(nullptr);
  write("<svg><path d='M0,0 L1,x'/></svg>");
  EXPECT_EQ(bb_curves_read(file.c_str(), message.data(), message.size(), &curves), BB_ERROR_FILE);
  EXPECT_NE(std::string(message.data()).find(".svg:1:23: "), std::string::npos) << message.data();
  EXPECT_EQ(bb_curves_read(file.c_str(), nullptr, 0, &curves), BB_ERROR_FILE);
  EXPECT_EQ(bb_curves_read("/absent.csv", message.data(), message.size(), &curves), BB_ERROR_FILE);
  EXPECT_STREQ(message.data(), "/absent.csv: cannot be read; check that it is a readable file");
  EXPECT_EQ(bb_curves_read(nullptr, nullptr, 0, &curves), BB_ERROR_NULL);
  std::remove(file.c_str());
}

/// x = 2t + t^2, x' = 2 + 2t, x'' = 2.
/// y = x^2 / 4 over [0, 3]: p(t) = (3 t, 9/4 t^2) has |C''| = 9/2, so that 2 chords keep a tolerance of 9/64.
TEST(C, ChordsLeadFromEndToEnd) {
  const std::vector<double> points{0, 0, 1.5, 0, 3, 2.25};
  const bb_curve parabola_of_x{BB_BERNSTEIN, 2, 2, points.data(), nullptr};
  constexpr std::array equal{2.0, 2.0, 2.0};
  const bb_curve weighted{BB_RATIONAL, 2, 2, points.data(), equal.data()};
  for (const auto& method : methods("flattening")) {
    if (method.min_degree > 2) continue;
    const bb_curve& curve = method.form == BB_RATIONAL ? weighted : parabola_of_x;
    std::size_t ends = 0;
    int complete = 0;
    ASSERT_EQ(bb_flatten(method.id, &curve, 9.0 / 64, nullptr, nullptr, 0, &ends, &complete), BB_OK) << method.id;
    ASSERT_GE(ends, 2U);
    EXPECT_EQ(complete, 1);
    std::vector<double> t(ends);
    std::vector<double> out(2 * ends);
    ASSERT_EQ(bb_flatten(method.id, &curve, 9.0 / 64, t.data(), out.data(), ends, &ends, &complete), BB_OK);
    EXPECT_EQ(std::vector<double>(out.begin(), out.begin() + 2), (std::vector<double>{0, 0})) << method.id;
    EXPECT_EQ(std::vector<double>(out.end() - 2, out.end()), (std::vector<double>{3, 2.25})) << method.id;
    if (std::string(method.id) == "wang_count") {
      EXPECT_EQ(t, (std::vector<double>{0, 0.5, 1}));
    }
  }
  std::size_t ends = 7;
  int complete = 7;
  const auto& curve = parabola_of_x;
  EXPECT_EQ(bb_flatten("halving_distance", &pole, 1, nullptr, nullptr, 0, &ends, &complete), BB_ERROR_NO_POINT);
  EXPECT_EQ(bb_flatten("wang_count", &curve, 0, nullptr, nullptr, 0, &ends, &complete), BB_ERROR_TOLERANCE);
  EXPECT_EQ(bb_flatten("wang_count", &rational_parabola, 1, nullptr, nullptr, 0, &ends, &complete), BB_ERROR_FORM);
  EXPECT_EQ(bb_flatten("wang_count", &curve, 1, nullptr, nullptr, 0, nullptr, &complete), BB_ERROR_NULL);
  EXPECT_EQ(bb_flatten("wang_count", &curve, 1, nullptr, nullptr, 9, &ends, &complete), BB_ERROR_NULL);
  EXPECT_EQ(bb_flatten("hain", &curve, 1, nullptr, nullptr, 0, &ends, &complete), BB_ERROR_DEGREE);
}

/// Of the circle C' = 2 / (1 + t^2) (-sin phi, cos phi), here at t = 1/2.
TEST(C, DerivativeOfARationalCurve) {
  for (const auto& method : methods("derivative")) {
    if (method.form != BB_RATIONAL) continue;
    std::array<double, 2> out{};
    const double t = 0.5;
    ASSERT_EQ(bb_derivative(method.id, &circle, 1, &t, 1, out.data()), BB_OK) << method.id;
    EXPECT_NEAR(out[0], -1.6 * 0.8, 1e-15) << method.id;
    EXPECT_NEAR(out[1], 1.6 * 0.6, 1e-15) << method.id;
  }
}

TEST(C, DerivativesAndGridsAreThoseOfTheCurve) {
  for (const auto& method : methods("derivative")) {
    if (method.form != BB_BERNSTEIN || std::string(method.id) == "seed_000")
      continue;  // which is wrong from order 2 on
    std::array<double, 2 * parameter_count> out{};
    for (const int order : {0, 1, 2, 3}) {
      ASSERT_EQ(bb_derivative(method.id, &parabola, order, parameters.data(), parameter_count, out.data()), BB_OK)
          << method.id;
      for (std::size_t k = 0; k < parameter_count; ++k) {
        const double t = parameters[k];
        const double expected = order == 0 ? 2 * t + t * t : order == 1 ? 2 + 2 * t : order == 2 ? 2 : 0;
        EXPECT_NEAR(out[2 * k], expected, 1e-14) << method.id << ", order " << order;
      }
    }
  }
  constexpr std::array equal{2.0, 2.0, 2.0};
  for (const auto& method : methods("grid")) {
    if (method.form == BB_POWER) continue;
    std::array<double, 10> out{};
    const bb_curve weighted{BB_RATIONAL, 2, 2, parabola.points, equal.data()};
    const bb_curve& curve = method.form == BB_RATIONAL ? weighted : parabola;
    ASSERT_EQ(bb_grid(method.id, &curve, 4, out.data()), BB_OK) << method.id;
    for (const int k : {0, 1, 2, 3, 4}) {
      const double t = k / 4.0;
      EXPECT_EQ(out[2 * static_cast<std::size_t>(k)], 2 * t + t * t) << method.id;
    }
  }
  double out = 7;
  const double t = 0.5;
  EXPECT_EQ(bb_derivative("differences_horner", &parabola, -1, &t, 1, &out), BB_ERROR_PARAMETER);
  EXPECT_EQ(bb_derivative("differences_de_casteljau", &rational_parabola, 1, &t, 1, &out), BB_ERROR_FORM);
  EXPECT_EQ(bb_derivative("de_casteljau", &parabola, 1, &t, 1, &out), BB_ERROR_METHOD);
  EXPECT_EQ(bb_grid("pointwise_de_casteljau", &parabola, 5, &out), BB_ERROR_COUNT);
  EXPECT_EQ(bb_grid("pointwise_de_casteljau", &parabola, 4, nullptr), BB_ERROR_NULL);
  std::array<double, 10> points{};
  EXPECT_EQ(bb_grid("pointwise_de_casteljau", &pole, 4, points.data()), BB_ERROR_NO_POINT);
  EXPECT_EQ(out, 7);
}

/// The weights 1, 1/2, 1 become 1, 3/4, 3/4 and 3/4, 3/4, 1; the second point is (b_0 + b_1 / 2) / (3/2), the third
/// (b_0 / 4 + b_1 / 4 + b_2 / 4) / (3/4).
TEST(C, HalvesAreThoseOfTheCurve) {
  std::array<double, 6> left{};
  std::array<double, 6> right{};
  std::array<double, 3> left_weights{};
  std::array<double, 3> right_weights{};
  const bb_half first{left.data(), left_weights.data()};
  const bb_half second{right.data(), right_weights.data()};
  for (const auto& method : methods("subdivision")) {
    const bool weighted = method.form == BB_RATIONAL;
    ASSERT_EQ(bb_split(method.id, weighted ? &rational_parabola : &parabola, 0.5, &first, &second), BB_OK) << method.id;
    const std::array<double, 5> x =
        weighted ? std::array{0.0, 1.0 / 3, 4.0 / 3, 7.0 / 3, 3.0} : std::array{0.0, 0.5, 1.25, 2.0, 3.0};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(left[2 * i], x[i], 1e-15) << method.id;
      EXPECT_NEAR(right[2 * i], x[2 + i], 1e-15) << method.id;
    }
    if (!weighted) continue;
    EXPECT_EQ(left_weights, (std::array{1.0, 0.75, 0.75}));
    EXPECT_EQ(right_weights, (std::array{0.75, 0.75, 1.0}));
  }
  EXPECT_EQ(bb_split("de_casteljau_split", &pole, 0.5, &first, &second), BB_ERROR_NO_POINT);
  const bb_half unweighted{left.data(), nullptr};
  EXPECT_EQ(bb_split("de_casteljau_split", &rational_parabola, 0.5, &unweighted, &second), BB_ERROR_NULL);
  EXPECT_EQ(bb_split("de_casteljau_split", &parabola, infinity, &first, &second), BB_ERROR_NOT_FINITE);
}

/// The parabola y = x (2 - x), x = 2t, from x = 1 to 2 and back, and as a cubic.
TEST(C, PartsAndElevatedCurves) {
  constexpr std::array arch{0.0, 0.0, 1.0, 2.0, 2.0, 0.0};
  constexpr std::array weights{1.0, 1.0, -1.0};  // 1 - 2 t^2, 0 in the blossom at 1/2 and 1
  const bb_curve curve{BB_BERNSTEIN, 2, 2, arch.data(), nullptr};
  std::array<double, 8> points{};
  const bb_half half{points.data(), nullptr};
  ASSERT_EQ(bb_part(&curve, 0.5, 1, &half), BB_OK);
  EXPECT_THAT(points, testing::ElementsAre(1, 1, 1.5, 1, 2, 0, 0, 0));
  ASSERT_EQ(bb_part(&curve, 1, 0.5, &half), BB_OK);
  EXPECT_THAT(points, testing::ElementsAre(2, 0, 1.5, 1, 1, 1, 0, 0));
  ASSERT_EQ(bb_elevate(&curve, 3, &half), BB_OK);
  EXPECT_THAT(points, testing::ElementsAre(0, 0, 2.0 / 3, 4.0 / 3, 4.0 / 3, 4.0 / 3, 2, 0));
  const bb_curve rational{BB_RATIONAL, 2, 2, arch.data(), weights.data()};
  EXPECT_EQ(bb_part(&rational, 0, 0.5, &half), BB_ERROR_NULL);
  std::array<double, 3> its_weights{};
  const bb_half weighted{points.data(), its_weights.data()};
  EXPECT_EQ(bb_part(&rational, 0.5, 1, &weighted), BB_ERROR_NO_POINT);
  EXPECT_EQ(bb_part(&curve, 0, infinity, &half), BB_ERROR_NOT_FINITE);
  EXPECT_EQ(bb_elevate(&curve, 1, &half), BB_ERROR_DEGREE);
  const bb_curve power{BB_POWER, 2, 2, arch.data(), nullptr};
  EXPECT_EQ(bb_elevate(&power, 3, &half), BB_ERROR_FORM);
}

/// x_k = (k + 1) t^2 + k: five axes give what each of them gives alone.
TEST(C, PointsAndPartsInFourAndFiveDimensions) {
  constexpr std::array<double, 3> weights{1, 2, 1};
  for (const int d : {4, 5})
    for (const bool rational : {false, true}) {
      const auto axes = static_cast<std::size_t>(d);
      std::vector<double> points(3 * axes);
      for (std::size_t k = 0; k < axes; ++k) {
        points[k] = points[axes + k] = static_cast<double>(k);
        points[2 * axes + k] = 2 * static_cast<double>(k) + 1;
      }
      const int form = rational ? BB_RATIONAL : BB_BERNSTEIN;
      const bb_curve curve{form, d, 2, points.data(), rational ? weights.data() : nullptr};
      const auto of_axis = [&](std::size_t k) { return std::array{points[k], points[axes + k], points[2 * axes + k]}; };
      std::vector<double> out(2 * axes);
      std::vector<double> exact(2 * axes);
      ASSERT_EQ(bb_curve_evaluate("de_casteljau", &curve, parameters.data(), 2, out.data()), BB_OK);
      ASSERT_EQ(bb_curve_exact(&curve, parameters.data(), 2, exact.data()), BB_OK);
      std::vector<double> left(3 * axes);
      std::vector<double> right(3 * axes);
      std::vector<double> part(3 * axes);
      std::vector<double> cubic(4 * axes);
      std::array<double, 4> some_weights{};
      const auto half = [&](std::vector<double>& of) {
        return bb_half{of.data(), rational ? some_weights.data() : nullptr};
      };
      const auto first = half(left);
      const auto second = half(right);
      const auto middle = half(part);
      const auto elevated = half(cubic);
      ASSERT_EQ(bb_split("de_casteljau_split", &curve, 0.25, &first, &second), BB_OK);
      ASSERT_EQ(bb_part(&curve, 0.25, 0.5, &middle), BB_OK);
      ASSERT_EQ(bb_elevate(&curve, 3, &elevated), BB_OK);
      for (std::size_t k = 0; k < axes; ++k) {
        const auto alone_points = of_axis(k);
        const bb_curve alone{form, 1, 2, alone_points.data(), curve.weights};
        std::array<double, 4> one{};
        std::array<double, 4> other{};
        const bb_half one_half{one.data(), rational ? some_weights.data() : nullptr};
        const bb_half other_half{other.data(), rational ? some_weights.data() : nullptr};
        const auto expect = [&](const std::vector<double>& all, const std::array<double, 4>& expected) {
          for (std::size_t i = 0; i * axes < all.size(); ++i)
            EXPECT_EQ(all[i * axes + k], expected[i]) << d << " " << k;
        };
        ASSERT_EQ(bb_curve_evaluate("de_casteljau", &alone, parameters.data(), 2, one.data()), BB_OK);
        expect(out, one);
        ASSERT_EQ(bb_curve_exact(&alone, parameters.data(), 2, one.data()), BB_OK);
        expect(exact, one);
        ASSERT_EQ(bb_split("de_casteljau_split", &alone, 0.25, &one_half, &other_half), BB_OK);
        expect(left, one);
        expect(right, other);
        ASSERT_EQ(bb_part(&alone, 0.25, 0.5, &one_half), BB_OK);
        expect(part, one);
        ASSERT_EQ(bb_elevate(&alone, 3, &one_half), BB_OK);
        expect(cubic, one);
      }
    }
  std::array<double, 12> points{};
  const bb_curve six{BB_BERNSTEIN, 6, 1, points.data(), nullptr};
  const bb_curve four{BB_BERNSTEIN, 4, 1, nullptr, nullptr};
  EXPECT_EQ(bb_curve_evaluate("de_casteljau", &six, parameters.data(), 1, points.data()), BB_ERROR_DIMENSION);
  EXPECT_EQ(bb_curve_evaluate("de_casteljau", &four, parameters.data(), 1, points.data()), BB_ERROR_NULL);
  std::array<double, 8> bad{1, 1, 1, infinity, 1, 1, 1, 1};
  std::array<double, 2> some_weights{77, 77};
  const bb_half half{points.data(), some_weights.data()};
  bb_curve curve{BB_RATIONAL, 4, 1, bad.data(), weights.data()};
  EXPECT_EQ(bb_part(&curve, 0, 0.5, &half), BB_ERROR_NOT_FINITE);
  EXPECT_EQ(bb_elevate(&curve, 1, &half), BB_ERROR_NOT_FINITE);
  EXPECT_EQ(bb_split("de_casteljau_split", &curve, 0.5, &half, &half), BB_ERROR_NOT_FINITE);
  EXPECT_EQ(some_weights, (std::array<double, 2>{77, 77}));
  curve.degree = -5;
  EXPECT_EQ(bb_split("de_casteljau_split", &curve, 0.5, &half, &half), BB_ERROR_DEGREE);
}

/// y = 1 - 4 t (1-t) touches 0 at t = 1/2; x = 2t.
TEST(C, RootsHaveMultiplicities) {
  constexpr std::array touching{0.0, 1.0, 1.0, -1.0, 2.0, 1.0};
  const bb_curve curve{BB_BERNSTEIN, 2, 2, touching.data(), nullptr};
  std::array<double, 2> t{7, 7};
  std::array<int, 2> multiplicities{7, 7};
  std::size_t count = 7;
  const auto roots = [&](const bb_curve& of_curve, int of, int axis, double value) {
    return bb_roots(&of_curve, of, axis, value, t.data(), multiplicities.data(), t.size(), &count);
  };
  ASSERT_EQ(roots(curve, BB_ROOTS_OF_VALUE, 1, 0), BB_OK);
  EXPECT_THAT(std::make_tuple(count, t[0], multiplicities[0], t[1]), testing::FieldsAre(1, 0.5, 2, 7));
  ASSERT_EQ(roots(curve, BB_ROOTS_OF_VALUE, 0, 0.5), BB_OK);
  EXPECT_THAT(std::make_tuple(count, t[0], multiplicities[0]), testing::FieldsAre(1, 0.25, 1));
  ASSERT_EQ(roots(curve, BB_ROOTS_OF_DERIVATIVE, 1, 0), BB_OK);
  EXPECT_THAT(std::make_tuple(count, t[0], multiplicities[0]), testing::FieldsAre(1, 0.5, 1));
  ASSERT_EQ(roots(curve, BB_ROOTS_OF_CURVATURE, 0, 0), BB_OK);
  EXPECT_EQ(count, 0);
  const bb_curve line{BB_BERNSTEIN, 2, 1, touching.data(), nullptr};
  ASSERT_EQ(roots(line, BB_ROOTS_OF_CURVATURE, 0, 0), BB_OK);
  EXPECT_EQ(count, SIZE_MAX);
  ASSERT_EQ(bb_roots(&curve, BB_ROOTS_OF_VALUE, 1, 0, nullptr, nullptr, 0, &count), BB_OK);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(roots(curve, BB_ROOTS_OF_VALUE, 2, 0), BB_ERROR_DIMENSION);
  EXPECT_EQ(roots(curve, 3, 2, 0), BB_ERROR_PARAMETER);
  EXPECT_EQ(roots(curve, BB_ROOTS_OF_VALUE, 0, infinity), BB_ERROR_NOT_FINITE);
  EXPECT_EQ(roots(pole, BB_ROOTS_OF_VALUE, 0, 0), BB_ERROR_NO_POINT);
}

/// x = 0, 1, 3 rises. With the weights 1, 1/2, 1 the y of the second curve, 0, 2, 0, is 2 t (1-t) / (1 - t + t^2).
TEST(C, BoxesContainTheCurve) {
  constexpr std::array arch{0.0, 0.0, 1.0, 2.0, 3.0, 0.0};
  constexpr std::array weights{1.0, 0.5, 1.0};
  const bb_curve polynomial{BB_BERNSTEIN, 2, 2, arch.data(), nullptr};
  const bb_curve weighted{BB_RATIONAL, 2, 2, arch.data(), weights.data()};
  for (const auto& method : methods("bounds")) {
    std::array<double, 4> box{};
    const bool is_rational = method.form == BB_RATIONAL;
    ASSERT_EQ(bb_box(method.id, is_rational ? &weighted : &polynomial, box.data()), BB_OK) << method.id;
    EXPECT_NEAR(box[0], 0, 1e-13) << method.id;
    EXPECT_NEAR(box[1], 3, 1e-13) << method.id;
    EXPECT_NEAR(box[2], 0, 1e-13) << method.id;
    const double top = is_rational ? 2.0 / 3 : 1;
    EXPECT_GE(box[3], top - 1e-13) << method.id;
    EXPECT_LE(box[3], std::string(method.id) == "control_box" ? 2 : top + 0.02) << method.id;
  }
  double out = 7;
  EXPECT_EQ(bb_box("exact", &polynomial, &out), BB_ERROR_METHOD);
  EXPECT_EQ(bb_box("split_box", &weighted, &out), BB_ERROR_FORM);
  EXPECT_EQ(bb_box("exact_box", &polynomial, nullptr), BB_ERROR_NULL);
  EXPECT_EQ(out, 7);
}

/// The length of t^3 up to t is t^3.
TEST(C, ParametersAreThoseOfTheLength) {
  const std::array<double, 4> cube{0, 0, 0, 1};
  const bb_curve curve{BB_BERNSTEIN, 1, 3, cube.data(), nullptr};
  bb_parameter found{};
  for (const auto& method : methods("inverse_arc_length")) {
    ASSERT_EQ(bb_at_length(method.id, &curve, 0.125, 1e-9, &found), BB_OK);
    if (found.converged == 0) continue;
    EXPECT_NEAR(found.t * found.t * found.t, 0.125, 1e-9) << method.id;
  }
  bb_length length{};
  ASSERT_EQ(bb_arc_length("gauss_legendre_adaptive", &parabola, 0, 1, 1e-9, &length), BB_OK);
  ASSERT_EQ(bb_at_length("bracketed_newton", &parabola, length.length, 1e-9, &found), BB_OK);  // as it was computed
  EXPECT_NEAR(found.t, 1, 1e-8);
  ASSERT_EQ(bb_at_length("bracketed_newton", &curve, 1 + 1e-10, 1e-9, &found), BB_OK);
  EXPECT_EQ(found.t, 1);
  EXPECT_EQ(found.converged, 1);
  for (const double outside : {1.1, -1e-12, not_a_number})
    EXPECT_EQ(bb_at_length("bracketed_newton", &curve, outside, 1e-9, &found), BB_ERROR_PARAMETER);
  EXPECT_EQ(bb_at_length("bracketed_newton", &curve, 0.5, 0, &found), BB_ERROR_TOLERANCE);
}

TEST(C, WhatIsWrongIsRefusedAndNothingIsWritten) {
  const double t = 0.5;
  double out = 7;
  const auto evaluate = [&](const char* method, int dimension, int degree, const double* b, const double* at) {
    return bb_evaluate(method, dimension, degree, b, at, 1, &out);
  };
  const double* b = parabola_points.data();
  EXPECT_EQ(evaluate("de_casteljau", 1, 2, nullptr, &t), BB_ERROR_NULL);
  EXPECT_EQ(evaluate("de_casteljau", 1, 2, b, nullptr), BB_ERROR_NULL);
  EXPECT_EQ(bb_evaluate("de_casteljau", 1, 2, b, &t, 1, nullptr), BB_ERROR_NULL);
  EXPECT_EQ(evaluate("", 1, 2, b, &t), BB_ERROR_METHOD);
  EXPECT_EQ(evaluate("horner", 1, 2, b, &t), BB_ERROR_FORM);
  EXPECT_EQ(evaluate("de_casteljau", 0, 2, b, &t), BB_ERROR_DIMENSION);
  EXPECT_EQ(evaluate("de_casteljau", 6, 2, b, &t), BB_ERROR_DIMENSION);
  EXPECT_EQ(evaluate("de_casteljau", 1, -1, b, &t), BB_ERROR_DEGREE);
  EXPECT_EQ(evaluate("de_casteljau", 1, 1024, b, &t), BB_ERROR_DEGREE);
  const std::vector<double> many(1024, 1.0);
  EXPECT_EQ(evaluate("direct", 1, 1023, many.data(), &t), BB_ERROR_DEGREE);
  EXPECT_EQ(evaluate("de_casteljau", 1, 2, b, &not_a_number), BB_ERROR_NOT_FINITE);
  const std::array lost{0.0, infinity};
  EXPECT_EQ(evaluate("de_casteljau", 1, 1, lost.data(), &t), BB_ERROR_NOT_FINITE);
  const double outside = 1.5;
  EXPECT_EQ(evaluate("correctly_rounded", 1, 2, b, &outside), BB_ERROR_PARAMETER);
  EXPECT_EQ(out, 7);
  EXPECT_EQ(bb_evaluate("de_casteljau", 1, 2, b, nullptr, 0, nullptr), BB_OK);  // no points are fine
  bb_method method;
  EXPECT_EQ(bb_method_at(bb_method_count(), &method), BB_ERROR_COUNT);
  EXPECT_EQ(bb_recommended(3, 2, 0), nullptr);
  EXPECT_EQ(bb_recommended(BB_BERNSTEIN, -1, 0), nullptr);
}

TEST(C, CurvesAreChecked) {
  const double t = 0.5;
  std::array<double, 2> out{};
  const auto exact = [&](const bb_curve& curve) { return bb_curve_exact(&curve, &t, 1, out.data()); };
  EXPECT_EQ(bb_curve_exact(nullptr, &t, 1, out.data()), BB_ERROR_NULL);
  EXPECT_EQ(exact({3, 2, 2, parabola_points.data(), nullptr}), BB_ERROR_FORM);
  EXPECT_EQ(exact({BB_RATIONAL, 2, 2, parabola_points.data(), nullptr}), BB_ERROR_NULL);
  constexpr std::array<double, 3> zeros{};
  EXPECT_EQ(exact({BB_RATIONAL, 2, 2, parabola_points.data(), zeros.data()}), BB_ERROR_NO_POINT);
  EXPECT_EQ(exact(pole), BB_ERROR_NO_POINT);
  double length = 0;
  const bb_curve power{BB_POWER, 2, 2, parabola_points.data(), nullptr};
  EXPECT_EQ(bb_exact_arc_length(&power, 0, 1, &length), BB_ERROR_FORM);
  EXPECT_EQ(bb_exact_arc_length(&parabola, 0.5, 0.25, &length), BB_ERROR_PARAMETER);
  EXPECT_EQ(bb_exact_arc_length(&parabola, 0, not_a_number, &length), BB_ERROR_PARAMETER);
  bb_length found;
  EXPECT_EQ(bb_arc_length("chord_sum", &parabola, 0, 1, 0, &found), BB_ERROR_TOLERANCE);
}

TEST(C, TruthsThatTakeLongAreStopped) {
  const volatile int flag = 1;
  std::array<double, 2> out{};
  bb_stop_when(&flag);
  const std::vector<int> stopped{bb_exact_project(&parabola, parabola_points.data(), &out[0], &out[1]),
                                 bb_project_error(&parabola, parabola_points.data(), 0, 0, out.data()),
                                 bb_exact_arc_length(&parabola, 0, 1, out.data()),
                                 bb_arc_length_error(&parabola, 0, 1, 0, out.data())};
  bb_stop_when(nullptr);
  EXPECT_EQ(stopped, std::vector<int>(4, BB_ERROR_STOPPED));
  EXPECT_EQ(bb_exact_project(&parabola, parabola_points.data(), &out[0], &out[1]), BB_OK);
}

/// Everything that computes, for its status.
std::vector<int> statuses() {
  std::array<double, 2> out{};
  const double t = 0.5;
  bb_error error[2];
  bb_bound bound[2];
  bb_length length;
  bb_foot foot;
  std::array<double, 16> segments;
  bb_parameter found;
  const bb_half half{segments.data(), nullptr};
  constexpr std::array<float, 6> single{0, 0, 1, 2, 3, 1};
  bb_fitted* fitted = nullptr;
  bb_prepared* prepared = nullptr;
  const bb_batch batch{BB_BERNSTEIN, 2, 2, 1, 1, nullptr, nullptr, nullptr};
  return {bb_evaluate("horner_bernstein", 2, 2, parabola_points.data(), &t, 1, out.data()),
          bb_evaluate_curves("horner_bernstein", &batch, parabola_points.data(), nullptr, &t, out.data()),
          bb_exact(2, 2, parabola_points.data(), &t, 1, out.data()),
          bb_curve_error(&parabola, &t, 1, out.data(), error),
          bb_curve_bound("de_casteljau", &parabola, &t, 1, bound),
          bb_arc_length("gauss_legendre_24", &parabola, 0, 1, 1e-9, &length),
          bb_exact_arc_length(&parabola, 0, 1, out.data()),
          bb_at_length("halley", &parabola, 1, 1e-9, &found),
          bb_derivative("differences_horner", &parabola, 1, &t, 1, out.data()),
          bb_grid("pointwise_de_casteljau", &parabola, 2, segments.data()),
          bb_split("de_casteljau_split", &parabola, t, &half, &half),
          bb_box("exact_box", &parabola, segments.data()),
          bb_bound_float("de_casteljau", 2, 2, single.data(), single.data(), 1, bound),
          bb_project("scan_refine", &parabola, parabola_points.data(), &foot),
          bb_interpolate(nullptr, 2, parabola_points.data(), 3, segments.data()),
          bb_prepare("de_casteljau", &parabola, &prepared) == BB_OK ? (bb_prepared_free(prepared), BB_OK)
                                                                    : BB_ERROR_ENVIRONMENT,
          bb_fit("gauss_newton", 2, parabola_points.data(), 3, 1, &fitted) == BB_OK ? (bb_fitted_free(fitted), BB_OK)
                                                                                    : BB_ERROR_ENVIRONMENT};
}

TEST(C, AnotherRoundingModeIsRefused) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto found = statuses();
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(after, mode);
    for (const int status : found) EXPECT_EQ(status, BB_ERROR_ENVIRONMENT);
  }
  for (const int status : statuses()) EXPECT_EQ(status, BB_OK);
}

#ifdef __SSE2__
TEST(C, FlushedSubnormalsAreRefused) {
  const unsigned before = _mm_getcsr();
  for (const unsigned bit : {0x8000U, 0x0040U}) {  // flush to zero, denormals are zero
    _mm_setcsr(before | bit);
    const auto found = statuses();
    _mm_setcsr(before);
    for (const int status : found) EXPECT_EQ(status, BB_ERROR_ENVIRONMENT);
  }
}
#endif

TEST(C, TheFlagsOfTheCallerAreLeftAlone) {
  std::feclearexcept(FE_ALL_EXCEPT);
  statuses();
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);
  std::feraiseexcept(FE_OVERFLOW);
  statuses();
  EXPECT_NE(std::fetestexcept(FE_OVERFLOW), 0);
  std::feclearexcept(FE_ALL_EXCEPT);
}

#ifdef __GLIBC__
TEST(C, TrapsOfTheCallerAreNotTakenAndLeftAlone) {
  feenableexcept(FE_ALL_EXCEPT);
  const auto found = statuses();
  const int after = fedisableexcept(FE_ALL_EXCEPT);
  EXPECT_EQ(after, FE_ALL_EXCEPT);
  for (const int status : found) EXPECT_EQ(status, BB_OK);
}
#endif

TEST(C, ThreadsDoNotDisturbEachOther) {
  std::vector<double> t;
  for (int i = 0; i <= 200; ++i) t.push_back(i / 200.0);
  bb_prepared* prepared = nullptr;
  ASSERT_EQ(bb_prepare("compensated_de_casteljau", &parabola, &prepared), BB_OK);
  const auto work = [&] {
    std::vector<double> values(2 * t.size());
    std::vector<double> exact(values.size());
    std::vector<bb_error> errors(values.size());
    EXPECT_EQ(bb_prepared_evaluate(prepared, t.data(), t.size(), values.data()), BB_OK);
    EXPECT_EQ(bb_exact(2, 2, parabola_points.data(), t.data(), t.size(), exact.data()), BB_OK);
    EXPECT_EQ(bb_curve_error(&parabola, t.data(), t.size(), values.data(), errors.data()), BB_OK);
    double length = 0;
    EXPECT_EQ(bb_exact_arc_length(&parabola, 0, 1, &length), BB_OK);
    exact.push_back(length);
    exact.insert(exact.end(), values.begin(), values.end());
    for (const auto& error : errors) exact.push_back(error.error);
    return exact;
  };
  const auto alone = work();
  std::vector<std::vector<double>> results(8);
  std::vector<std::thread> threads;
  for (auto& result : results)
    threads.emplace_back([&] {
      for (int k = 0; k < 3; ++k) result = work();
    });
  for (auto& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, alone);
  bb_prepared_free(prepared);
}

TEST(C, EveryStatusHasASentence) {
  for (int status = BB_OK; status <= BB_ERROR_INTERNAL; ++status) {
    const std::string sentence = bb_strerror(status);
    EXPECT_FALSE(sentence.empty());
    EXPECT_NE(sentence, bb_strerror(-1)) << status;
  }
}

}  // namespace
