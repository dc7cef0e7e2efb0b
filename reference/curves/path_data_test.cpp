// SPDX-License-Identifier: MIT
// Expected values are those of [SVG 2, chapter 9], worked by its rules, or the equation of the ellipse.
#include "reference/curves/path_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference/curves/csv.hpp"

namespace bezierbench::curves {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CurveSet set_of(std::string_view data) { return read_path_data(data, "p.txt").set; }

std::vector<double> coefficients(const CurveSet& set, std::size_t k) {
  return {set[k].coefficients.begin(), set[k].coefficients.end()};
}

std::string refusal_of(std::string_view data) {
  try {
    (void)read_path_data(data, "p.txt");
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "read";
}

/// The point of a curve of degree 1 to 3 at t.
PlanePoint point_of(const CurveView<double>& curve, double t) {
  double w = 0;
  PlanePoint p{};
  for (int i = 0; i <= curve.degree; ++i) {
    const double choose = i == 0 || i == curve.degree ? 1 : curve.degree;
    const double basis = choose * std::pow(t, i) * std::pow(1 - t, curve.degree - i) *
                         (curve.weights.empty() ? 1 : curve.weights[static_cast<std::size_t>(i)]);
    w += basis;
    for (int axis = 0; axis < 2; ++axis) p.at(static_cast<std::size_t>(axis)) += basis * curve(axis, i);
  }
  return {p[0] / w, p[1] / w};
}

TEST(PathData, TriangleOfTheSpecification) {
  const auto read = read_path_data("M 100 100 L 300 100 L 200 300 z", "p.txt");
  ASSERT_EQ(read.set.size(), 3);
  EXPECT_THAT(coefficients(read.set, 0), ElementsAre(100, 100, 300, 100));
  EXPECT_THAT(coefficients(read.set, 2), ElementsAre(200, 300, 100, 100));
  EXPECT_EQ(read.set.id(2), "0:0:2");
  EXPECT_TRUE(read.set.begins_path(0));
  EXPECT_FALSE(read.set.begins_path(2));
  EXPECT_TRUE(read.left_out.empty());
}

TEST(PathData, SmoothCurvesMirrorTheControlPointBefore) {
  const auto cubics = set_of("M100,200 C100,100 250,100 250,200 S400,300 400,200");
  EXPECT_THAT(coefficients(cubics, 1), ElementsAre(250, 200, 250, 300, 400, 300, 400, 200));
  const auto quadratics = set_of("M200,300 Q400,50 600,300 T1000,300");
  EXPECT_THAT(coefficients(quadratics, 1), ElementsAre(600, 300, 800, 550, 1000, 300));
  // Without a curve of the kind before it, the control point is the current point.
  EXPECT_THAT(coefficients(set_of("M1,2 S3,4 5,6"), 0), ElementsAre(1, 2, 1, 2, 3, 4, 5, 6));
  EXPECT_THAT(coefficients(set_of("M0,0 C0,1 1,1 1,0 T2,0"), 1), ElementsAre(1, 0, 1, 0, 2, 0));
  EXPECT_THAT(coefficients(set_of("M0,0 Q1,1 2,0 L4,0 T6,0"), 2), ElementsAre(4, 0, 4, 0, 6, 0));
  EXPECT_THAT(coefficients(set_of("M0,0 t2,0 t2,2"), 1), ElementsAre(2, 0, 4, 0, 4, 2));
}

TEST(PathData, SpellingsOfTheGrammarAreTheSamePath) {
  const auto expect_same = [](std::string_view a, std::string_view b) {
    EXPECT_EQ(to_csv(set_of(a)), to_csv(set_of(b))) << a << " | " << b;
  };
  expect_same("M 100 100 L 200 200", "M100 100L200 200");
  expect_same("M 100 200 L 200 100 L -100 -200", "M 100 200 L 200 100 -100 -200");
  expect_same("M 100 200 L 200 100 L -100 -200", "M 100 200 200 100 -100 -200");
  expect_same("M0.6.5L100-200", "M 0.6 0.5 L 100 -200");
  expect_same("M1e2,+3E0l.5e+1-1", "M100,3L105,2");
  expect_same("\tM\r\n0 , 0\fL 1,1 ", "M0,0L1,1");
}

TEST(PathData, RelativeCommandsAreAbsoluteOnesMoved) {
  EXPECT_EQ(to_csv(set_of("m1,2 l3,4 h5 v6 c1,2 3,4 5,6 s1,2 3,4 q1,2 3,4 t5,6 a3,3 0 0 1 3,3 z m1,1 2,2")),
            to_csv(set_of(
                "M1,2 L4,6 H9 V12 C10,14 12,16 14,18 S15,20 17,22 Q18,24 20,26 T25,32 A3,3 0 0 1 28,35 Z M2,3 L4,5")));
}

TEST(PathData, SubpathsBeginPaths) {
  const auto set = set_of("M0,0 L1,0 L1,1 z L5,5 M7,7 8,8 M9,9");
  std::vector<std::string> ids;
  std::vector<bool> begins;
  for (std::size_t k = 0; k < set.size(); ++k) {
    ids.emplace_back(set.id(k));
    begins.push_back(set.begins_path(k));
  }
  EXPECT_THAT(ids, ElementsAre("0:0:0", "0:0:1", "0:0:2", "0:1:0", "0:2:0"));
  EXPECT_THAT(begins, ElementsAre(true, false, false, true, true));
  EXPECT_THAT(coefficients(set, 3), ElementsAre(0, 0, 5, 5));  // from the start of the closed subpath
}

TEST(PathData, ClosingLinesOfLengthZeroAreLeftOut) {
  const auto read = read_path_data("M0,0 L1,1 L0,0 z M0,0 z", "p.txt");
  EXPECT_EQ(read.set.size(), 2);
  EXPECT_THAT(read.left_out, ElementsAre(testing::Pair("closing lines of length 0", 2)));
}

TEST(PathData, ArcsOfTheSpecification) {
  // The pie of section 9.3.8: three quarters of a circle about (300,200).
  const auto set = set_of("M300,200 h-150 a150,150 0 1,0 150,-150 z");
  EXPECT_EQ(set[1].form, Form::rational);
  double turned = 0;
  for (std::size_t k = 1; k + 1 < set.size(); ++k) {
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
      const auto p = point_of(set[k], t);
      EXPECT_NEAR(std::hypot(p[0] - 300, p[1] - 200), 150, 1e-12);
    }
    turned += 2 * std::acos(set[k].weights[1]);
  }
  EXPECT_NEAR(turned, 1.5 * std::numbers::pi, 1e-14);
  // A quarter: the tangents meet in the corner.
  const auto quarter = set_of("M275,175 v-150 a150,150 0 0,0 -150,150 z");
  ASSERT_EQ(quarter.size(), 3);
  EXPECT_NEAR(quarter[1](0, 1), 125, 1e-12);
  EXPECT_NEAR(quarter[1](1, 1), 25, 1e-12);
  EXPECT_NEAR(quarter[1].weights[1], std::numbers::sqrt2 / 2, 1e-15);
}

TEST(PathData, HalfEllipsesAreTwoQuarters) {
  for (const char* flags : {"0 1", "1 1"}) {
    const auto set = set_of(std::string("M0,0 A5,2 0 ") + flags + " 10,0");
    ASSERT_EQ(set.size(), 2);
    EXPECT_THAT(coefficients(set, 0), ElementsAre(0, 0, 0, -2, 5, -2));
    EXPECT_THAT(coefficients(set, 1), ElementsAre(5, -2, 10, -2, 10, 0));
  }
}

TEST(PathData, ArcsOutOfRange) {  // section 9.5.1 and F.6.6
  EXPECT_THAT(coefficients(set_of("M1,2 A0,9 0 0 1 3,4"), 0), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(set_of("M1,2 A9,9 0 0 1 1,2").size(), 0);
  EXPECT_EQ(read_path_data("M1,2 A9,9 0 0 1 1,2", "p").left_out.at("arcs that end where they start"), 1);
  EXPECT_EQ(to_csv(set_of("M1,2 A-3,-4 0 0 1 3,4")), to_csv(set_of("M1,2 A3,4 0 0 1 3,4")));
  EXPECT_EQ(to_csv(set_of("M0,0 A1,1 0 0 1 8,0")), to_csv(set_of("M0,0 A4,4 0 1 1 8,0")));  // radii scaled up
  EXPECT_EQ(to_csv(set_of("M0,0a1 1 0 01.5.5")), to_csv(set_of("M0,0 a 1,1 0 0 1 0.5,0.5")));
  EXPECT_THAT(refusal_of("M0,0 A1e-320,5 0 0 1 8,0"), HasSubstr("an arc whose radii are not in the range of doubles"));
  EXPECT_EQ(set_of("M0,0 A1e200,1e200 0 0 1 1e-100,0").size(), 1U);
}

TEST(PathData, PointsOfArcsAreOnTheirEllipse) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const PlanePoint radii{std::exp(uniform(-3, 3)), std::exp(uniform(-3, 3))};
    const double degrees = trial % 4 == 0 ? 90 * (trial % 16) : uniform(-400, 400);
    const double phi = degrees * std::numbers::pi / 180;
    const double from = uniform(0, 7);
    const double extent = uniform(0.01, 2 * std::numbers::pi - 0.01);
    const bool large = extent > std::numbers::pi;
    const bool sweep = trial % 2 == 0;
    const PlanePoint centre{uniform(-9, 9), uniform(-9, 9)};
    const auto at = [&](double angle) -> PlanePoint {  // [SVG 2, F.6.3]
      const double x = radii[0] * std::cos(angle);
      const double y = radii[1] * std::sin(angle);
      return {std::cos(phi) * x - std::sin(phi) * y + centre[0], std::sin(phi) * x + std::cos(phi) * y + centre[1]};
    };
    Read read;
    Path path(read, "p", {}, "p");
    path.move_to(at(from));
    const auto end = at(from + (sweep ? extent : -extent));
    path.arc_to(radii, degrees, large, sweep, end);
    double turned = 0;
    for (std::size_t k = 0; k < read.set.size(); ++k) {
      const auto curve = read.set[k];
      EXPECT_GE(curve.weights[1], std::numbers::sqrt2 / 2 - 1e-12);
      const double angle = 2 * std::acos(std::min(1.0, curve.weights[1]));
      // Near half an ellipse the centre is as uncertain as the root of the rounding error.
      const double near_half = std::abs(extent - std::numbers::pi);
      const double tolerance = 1e-11 * std::max(radii[0], radii[1]) / std::min(1.0, std::max(1e-4, near_half));
      const auto middle = at(from + (sweep ? 1 : -1) * (turned + angle / 2));
      const auto p = point_of(curve, 0.5);
      EXPECT_NEAR(p[0], middle[0], tolerance) << trial;
      EXPECT_NEAR(p[1], middle[1], tolerance) << trial;
      turned += angle;
    }
    EXPECT_NEAR(turned, extent, 1e-6) << trial;
    EXPECT_EQ(read.set[read.set.size() - 1](0, 2), end[0]);
    EXPECT_EQ(read.set[read.set.size() - 1](1, 2), end[1]);
  }
}

TEST(PathData, ShortArcsOfLargeEllipsesKeepTheirDigits) {
  const auto set = set_of("M0,0 A1e12,1e12 0 0 1 1,0");  // the sagitta is 1/8e12, the control point twice as high
  EXPECT_DOUBLE_EQ(set[0](1, 1), -0.25e-12);
  EXPECT_DOUBLE_EQ(set[0](0, 1), 0.5);
}

TEST(PathData, AMapOfAPathIsTheMapOfItsPoints) {
  const Affine map{0, 2, -4, 0.5, 3, 5};
  const std::string data = "M1,2 L3,4 C5,6 7,8 9,10 Q1,2 3,4 A2,1 30 0 1 5,5 z";
  Read plain;
  Read mapped;
  for (const auto& [read, with] : {std::pair(&plain, Affine()), std::pair(&mapped, map)}) {
    Path path(*read, "p", with, "p");
    draw(data, {data, "p"}, 0, path);
  }
  ASSERT_EQ(plain.set.size(), mapped.set.size());
  for (std::size_t k = 0; k < plain.set.size(); ++k)
    for (int i = 0; i <= plain.set[k].degree; ++i) {
      const PlanePoint p{plain.set[k](0, i), plain.set[k](1, i)};
      EXPECT_EQ(mapped.set[k](0, i), map(p)[0]);
      EXPECT_EQ(mapped.set[k](1, i), map(p)[1]);
    }
}

TEST(PathData, DirectionsAreExactAtRightAngles) {
  EXPECT_THAT(direction_of(90), ElementsAre(0, 1));
  EXPECT_THAT(direction_of(-90), ElementsAre(0, -1));
  EXPECT_THAT(direction_of(180), ElementsAre(-1, 0));
  EXPECT_THAT(direction_of(720), ElementsAre(1, 0));
  EXPECT_EQ(direction_of(60)[0], 0.5);
  EXPECT_EQ(direction_of(390)[1], 0.5);
}

TEST(PathData, ErrorsNameTheirPlace) {
  EXPECT_EQ(set_of("").size(), 0);
  EXPECT_EQ(set_of(" \n").size(), 0);
  for (const auto& [data, place] : {std::pair("L1,1", "p.txt:1:1: "),
                                    {"M10,10 L20,20,30", "p.txt:1:17: "},
                                    {"M1,2\nL3,4\n 5,x", "p.txt:3:4: "},
                                    {"M1,2 A1,1 0 2 0 3,3", "p.txt:1:13: "},
                                    {"M1,2 z 3,4", "p.txt:1:8: "},
                                    {"M0,0 L1,1,", "comma"},
                                    {"M0,0 L1,,1", "p.txt:1:9: "},
                                    {"M,0,0", "p.txt:1:2: "},
                                    {"M1e999,0", "too large"},
                                    {"M1e-999,0", "too small"},
                                    {"Mnan,0", "p.txt:1:2: "},
                                    {"Minf,0", "p.txt:1:2: "},
                                    {"M0x1p3,0", "p.txt:1:3: "},
                                    {"M0,0 l1.,2", "digit after the point"},
                                    {"M0,0 L\x1b[2J,1", "\\x1b"},
                                    {"M1e308,0 l1e308,0", "beyond the largest double"},
                                    {"M0,0 B1,1", "\"B1,1\""}})
    EXPECT_THAT(refusal_of(data), HasSubstr(place)) << data;
}

}  // namespace
}  // namespace bezierbench::curves
