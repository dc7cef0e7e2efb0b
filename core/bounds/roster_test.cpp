// SPDX-License-Identifier: MIT
// Properties of every method, on curves whose extrema are known or found exactly.
#include "core/bounds/roster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/bounds/kernel.hpp"
#include "reference/companion/exact_roots.hpp"

namespace bezierbench {
namespace {

struct Given {
  std::vector<double> b;
  std::vector<double> w;

  [[nodiscard]] CurveView<double> view(Form form) const {
    return {form, 1, static_cast<int>(b.size()) - 1, b,
            form == Form::rational ? std::span(w) : std::span<const double>()};
  }
};

Range box_of(const BoundsKernel& method, const Given& given) {
  Range range{};
  double sides[2];
  method.box(given.view(method.info->form), sides);
  range = {sides[0], sides[1]};
  return range;
}

/// Curves of many sizes, some of them flat, with doubles of few and of many bits.
std::vector<Given> curves() {
  std::mt19937_64 words(1);  // its sequence is fixed by the standard
  const auto uniform = [&] { return static_cast<double>(words() >> 11U) * 0x1p-52 - 1; };
  std::vector<Given> all{{{3}, {1}},
                         {{1, -2, 4}, {1, 1, 1}},
                         {{0, 1, 0}, {1, 1, 1}},
                         {{0, 1, -1, 0}, {1, 2, 3, 4}},
                         {{0.1, 0.1, 0.1, 0.1}, {1, 2, 3, 4}},
                         {{0, 0x1p-1074, 0, 0x1p-1074}, {1, 1, 1, 1}},
                         {{0x1.8p1023, -0x1.8p1023, 0x1.8p1023, -0x1.8p1023}, {1, 1, 1, 1}},
                         {{1, 0x1.0000000000001p0, 0x1.fffffffffffffp-1, 1}, {1, 1, 1, 1}}};
  for (int degree = 1; degree <= 8; ++degree)
    for (int k = 0; k < 40; ++k) {
      Given given;
      const double scale = std::ldexp(1, static_cast<int>(words() % 80) - 40);
      const double middle = k % 4 == 0 ? 1000 * scale : 0;
      for (int i = 0; i <= degree; ++i) {
        given.b.push_back(k % 3 == 0 ? std::floor(4 * uniform()) : middle + scale * uniform());
        given.w.push_back(std::ldexp(1 + std::abs(uniform()), static_cast<int>(words() % 9) - 4));
      }
      all.push_back(std::move(given));
    }
  return all;
}

template <class Use>
void each_box(Use use) {
  for (const auto& given : curves())
    for (const auto& method : bounds_kernels(1))
      if (method.info->supports<double>(static_cast<int>(given.b.size()) - 1)) use(method, given);
}

std::int64_t doubles_between(double from, double to) {
  std::int64_t count = 0;
  for (; from < to && count < 3; ++count) from = std::nextafter(from, to);
  return count;
}

TEST(Bounds, PromisesAreKept) {
  each_box([](const BoundsKernel& method, const Given& given) {
    const auto exact = reference::exact_range(given.view(method.info->form), 0);
    const auto box = box_of(method, given);
    if (method.promises->contains) {
      EXPECT_LE(box.low, exact.low) << method.info->id << given.b.size();
      EXPECT_GE(box.high, exact.high) << method.info->id;
    }
    if (method.promises->within_one_ulp) {
      EXPECT_LE(doubles_between(box.low, exact.low), 1) << method.info->id;
      EXPECT_LE(doubles_between(exact.high, box.high), 1) << method.info->id;
    }
  });
}

/// A box is never larger than that of the control points by more than roundings, and contains the ends.
TEST(Bounds, BetweenEndsAndControlPoints) {
  each_box([](const BoundsKernel& method, const Given& given) {
    const auto box = box_of(method, given);
    const auto [least, largest] = std::ranges::minmax(given.b);
    const double size = std::max(std::abs(least), std::abs(largest));
    if (size > 0x1p1022 || size < 0x1p-1000) return;  // a method without a promise may overflow, or underflow
    EXPECT_GE(box.low, least - 0x1p-48 * size) << method.info->id;
    EXPECT_LE(box.high, largest + 0x1p-48 * size) << method.info->id;
    EXPECT_LE(box.low, std::min(given.b.front(), given.b.back())) << method.info->id;
    EXPECT_GE(box.high, std::max(given.b.front(), given.b.back())) << method.info->id;
  });
}

/// The methods that seek extrema find them. The bound of split_box is the largest: 6 (7 + 8) 8 u M, below 2^-43 M.
TEST(Bounds, ExtremaAreFound) {
  each_box([](const BoundsKernel& method, const Given& given) {
    if (method.info->id == "control_box" || method.info->id == "halved_polygon_box") return;
    const auto exact = reference::exact_range(given.view(method.info->form), 0);
    const auto [least, largest] = std::ranges::minmax(given.b);
    const double size = std::max(std::abs(least), std::abs(largest));
    if (size > 0x1p1022 || size < 0x1p-1000) return;
    const auto box = box_of(method, given);
    EXPECT_NEAR(box.low, exact.low, 0x1p-42 * size) << method.info->id;
    EXPECT_NEAR(box.high, exact.high, 0x1p-42 * size) << method.info->id;
  });
}

TEST(Bounds, NegatedCurvesHaveTheMirroredBox) {
  each_box([](const BoundsKernel& method, const Given& given) {
    auto negated = given;
    for (double& x : negated.b) x = -x;
    const auto box = box_of(method, given);
    const auto mirrored = box_of(method, negated);
    EXPECT_EQ(box.low, -mirrored.high) << method.info->id;
    EXPECT_EQ(box.high, -mirrored.low) << method.info->id;
  });
}

TEST(Bounds, EveryAxisIsABoxOfItsOwn) {
  const std::vector<double> points{0, 5, -1, 3, 2, 8, -4, 1, 0, 0, 7, 3};  // x y z of four points
  for (const auto& method : bounds_kernels(3)) {
    const std::vector<double> weights =
        method.info->form == Form::rational ? std::vector<double>{1, 2, 3, 4} : std::vector<double>{};
    double box[6];
    method.box({method.info->form, 3, 3, points, weights}, box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Given alone{{points[axis], points[3 + axis], points[6 + axis], points[9 + axis]}, weights};
      for (const auto& other : bounds_kernels(1)) {
        if (other.info != method.info) continue;
        const auto range = box_of(other, alone);
        EXPECT_EQ(range.low, box[2 * axis]);
        EXPECT_EQ(range.high, box[2 * axis + 1]);
      }
    }
  }
}

TEST(Bounds, WeightsOfBothSignsGiveNoFiniteBox) {
  for (const auto& method : bounds_kernels(1)) {
    if (method.info->form != Form::rational) continue;
    const auto box = box_of(method, {{0, 1, 0}, {1, -1, 1}});
    EXPECT_EQ(box.low, whole_axis.low);
    EXPECT_EQ(box.high, whole_axis.high);
    const auto negative = box_of(method, {{0, 1, 0}, {-1, -2, -1}});
    const auto positive = box_of(method, {{0, 1, 0}, {1, 2, 1}});
    EXPECT_EQ(negative.high, positive.high);
  }
}

/// (3t - 1)^2 has its minimum 0 at 1/3: the search goes down to the smallest number.
TEST(Bounds, ExactBoxNextToZero) {
  for (const auto& method : bounds_kernels(1)) {
    if (method.info->id != "exact_box") continue;
    const auto box = box_of(method, {{1, -2, 4}, {1, 1, 1}});
    EXPECT_LE(box.low, 0);
    EXPECT_GE(box.low, -0x1p-1074);
    EXPECT_EQ(box.high, 4);
  }
}

}  // namespace
}  // namespace bezierbench
