// SPDX-License-Identifier: MIT
#include "experiments/sample/thin.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/sample/draw.hpp"

namespace bezierbench::sample {
namespace {

TEST(Thin, IsWholeOnTheFirstAxisAndNextToNothingOnOthers) {
  constexpr int trials = 400;
  int zigzags = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    Trial out;
    draw(1, 2, {Form::bernstein, 3, 5, 0x1p-700, {}, "thin"}, trial, out);
    bool zigzag = true;
    for (std::size_t k = 0; k < out.coefficients.size(); ++k) {
      const double x = std::ldexp(out.coefficients[k], 700 + 5);
      if (k % 3 == 0) {
        EXPECT_EQ(x, std::round(x)) << trial;
        EXPECT_LE(std::abs(x), 32) << trial;
        zigzag = zigzag && (k / 3 % 2 == 0 ? x <= 0 : x >= 0);
      } else {
        EXPECT_EQ(std::ldexp(x, 20), std::round(std::ldexp(x, 20))) << trial;
        EXPECT_LE(std::abs(x), 2) << trial;
      }
    }
    zigzags += zigzag ? 1 : 0;
  }
  EXPECT_NEAR(zigzags, trials / 2 + trials / 128, 55);  // one in 64 of the other curves zigzags by chance
}

TEST(Thin, OnOneAxisIsWhole) {
  Trial out;
  draw(1, 2, {Form::bernstein, 1, 40, 32, {}, "thin"}, 7, out);
  for (const double x : out.coefficients) EXPECT_EQ(x, std::round(x));
}

}  // namespace
}  // namespace bezierbench::sample
