// SPDX-License-Identifier: MIT
#include "core/api/box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace bezierbench {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// A side that contains `tightest` and is not farther than `most` from it.
void expect_side(double side, double tightest, double most) {
  EXPECT_GE(side, tightest);
  EXPECT_LE(side, tightest + most);
}

/// The apex of the parabola is (1, 1).
TEST(BoxApi, OfAParabola) {
  const Points parabola{{0, 0}, {1, 2}, {2, 0}};
  for (const auto& sides : {box(parabola), box(std::array{parabola[0], parabola[1], parabola[2]}),
                            box<ExactBox<Form::bernstein>>(parabola)}) {
    EXPECT_EQ(sides[0].low, 0);
    EXPECT_EQ(sides[0].high, 2);
    EXPECT_EQ(sides[1].low, 0);
    expect_side(sides[1].high, 1, 1e-12);
  }
  EXPECT_EQ(box<ControlBox<Form::bernstein>>(parabola)[1].high, 2);
}

/// An arc of the circle x^2 + y^2 = 15^2, whose top is (0, 15).
TEST(BoxApi, OfAnArc) {
  const Points arc{{-12, 9}, {0, 25}, {12, 9}};
  const auto sides = box(arc, std::vector<double>{5, 3, 5});
  EXPECT_EQ(sides[0].low, -12);
  EXPECT_EQ(sides[0].high, 12);
  EXPECT_EQ(sides[1].low, 9);
  expect_side(sides[1].high, 15, 0x1p-49);  // the next double
  EXPECT_EQ(box(arc, std::vector<double>{5, -3, 5})[1].high, std::numeric_limits<double>::infinity());
}

TEST(BoxApi, RefusesWhatItCannotDo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points line{{0, 0}, {1, 1}};
  EXPECT_THROW((void)box(Points{}), std::invalid_argument);
  EXPECT_THROW((void)box(Points{{0, 0}, {1, nan}}), std::invalid_argument);
  EXPECT_THROW((void)box<QuadraticFormulaBox<false>>(Points(9)), std::invalid_argument);
  EXPECT_THROW((void)box(line, std::vector<double>{1}), std::invalid_argument);
  EXPECT_THROW((void)box(line, std::vector<double>{0, 0}), std::invalid_argument);
  EXPECT_THROW((void)box(line, std::vector<double>{1, nan}), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench
