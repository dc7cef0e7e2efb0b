// SPDX-License-Identifier: MIT
#include "experiments/guarantees/statements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "core/evaluate/guarantee.hpp"
#include "experiments/guarantees/draws.hpp"

namespace bezierbench::guarantees {
namespace {

template <class Scalar>
const Statement<Scalar>& of(Property property) {
  return *std::ranges::find(statements<Scalar>, property, &Statement<Scalar>::property);
}

Excess excess(Property property, std::string_view method, const Case<double>& input) {
  Evaluation<double> evaluation(*find_kernel<double>(method, Form::bernstein, input.dimension));
  return of<double>(property).excess(evaluation, input);
}

Case<double> line(std::vector<double> coefficients, double t, double t_next = 0, double offset = 0) {
  return {1, std::move(coefficients), t, t_next, offset};
}

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

// Every expected difference below is by hand, from the formula of the method.
TEST(Statements, DecideKnownInputs) {
  // 1 + (2^-60 - 1) loses the end.
  EXPECT_EQ(excess(Property::ends_exact, "de_casteljau_lerp", line({1, 0x1p-60}, 1)), 0x1p+52);
  EXPECT_EQ(excess(Property::ends_exact, "de_casteljau", line({1, 0x1p-60}, 1)), 0);
  // Half of the smallest number twice is 0.
  EXPECT_EQ(excess(Property::constant_reproduced, "de_casteljau_fma", line({smallest, smallest}, 0.5)), 1);
  EXPECT_EQ(excess(Property::constant_reproduced, "de_casteljau_lerp", line({smallest, smallest}, 0.5)), 0);
  EXPECT_GT(excess(Property::in_hull, "de_casteljau_fma", line({smallest, smallest}, 0.5)), 0);
  EXPECT_GT(excess(Property::monotone, "de_casteljau_fma", line({smallest, smallest}, 0.25, 0.5)), 0);
  EXPECT_EQ(excess(Property::monotone, "de_casteljau", line({1, 2}, 0.25, 0.5)), -0x1p+50);
  EXPECT_EQ(excess(Property::in_hull, "de_casteljau", line({1, 2}, 0)), 0);
  EXPECT_EQ(excess(Property::finite, "de_casteljau_lerp", line({largest, -largest}, 0.5)), infinite);
  EXPECT_EQ(excess(Property::finite, "de_casteljau", line({largest, -largest}, 0.5)), -1);
  EXPECT_EQ(excess(Property::total, "correctly_rounded", line({1, 2}, 2)), infinite);
  EXPECT_EQ(excess(Property::total, "de_casteljau", line({1, 2}, 2)), 0);
}

TEST(Statements, SayNothingOfOtherInputs) {
  EXPECT_EQ(excess(Property::ends_exact, "de_casteljau", line({1, 2}, 0.5)), std::nullopt);
  EXPECT_EQ(excess(Property::ends_exact, "de_casteljau_lerp", line({largest, -largest}, 1)), std::nullopt);  // NaN
  EXPECT_EQ(excess(Property::reversal, "de_casteljau", line({1, 2}, 0x1p-60)), std::nullopt);
  EXPECT_EQ(excess(Property::translation, "de_casteljau", line({1, 2}, 0.5, 0, 0x1p-60)), std::nullopt);
  EXPECT_EQ(excess(Property::scaling_by_two, "de_casteljau", line({smallest, 1}, 0.5)), std::nullopt);
  EXPECT_EQ(excess(Property::scaling_by_two, "de_casteljau", line({largest, 1}, 0.5)), std::nullopt);
  EXPECT_EQ(excess(Property::total, "de_casteljau", line({1, 2}, 0.5)), std::nullopt);
  EXPECT_EQ(excess(Property::total, "de_casteljau", line({largest, 2}, 2)), std::nullopt);
}

TEST(Statements, AreAboutTheInputsThatTheyFit) {
  sample::Words words(1, 2, 3, 4);
  Draws<float> draws(words);
  for (const auto& statement : statements<float>) {
    Case<float> input{2, std::vector<float>(8), 0, 0, 0};
    Evaluation<float> evaluation(*find_kernel<float>("correctly_rounded", Form::bernstein, 2));
    int judged = 0;
    for (int k = 0; k < 400; ++k) {
      draws.full(input, statement.axes(2));
      statement.fit(input);
      auto again = input;
      statement.fit(again);
      EXPECT_FALSE(input < again || again < input) << name(statement.property);
      if (statement.excess(evaluation, input)) ++judged;
    }
    EXPECT_GT(judged, statement.uses_offset ? 200 : 390) << name(statement.property);
  }
}

TEST(ConvexHull, DistanceOutside) {
  const std::vector<PlanePoint> triangle{{0, 0}, {4, 0}, {0, 3}};
  EXPECT_EQ(distance_outside({1, 1}, triangle), 0);
  EXPECT_EQ(distance_outside({2, 1.5}, triangle), 0);  // on an edge
  EXPECT_EQ(distance_outside({4, 0}, triangle), 0);
  EXPECT_EQ(distance_outside({2, -1}, triangle), 1);
  EXPECT_EQ(distance_outside({7, -4}, triangle), 5);
  EXPECT_EQ(distance_outside({4, 3}, triangle), 2.4);
  EXPECT_GT(distance_outside({2, 1.5 + 0x1p-52}, triangle), 0);
  EXPECT_GT(distance_outside({2, -smallest}, triangle), 0);
  const std::vector<PlanePoint> segment{{0, 0}, {1, 3}, {0, 0}};
  EXPECT_EQ(distance_outside({0.5, 1.5}, segment), 0);
  EXPECT_GT(distance_outside({0x1.5555555555555p-2, 1}, segment), 0);
  EXPECT_EQ(distance_outside({2, 3}, std::vector<PlanePoint>{{1, 3}}), 1);
  EXPECT_EQ(distance_outside({-1, -3}, segment), std::sqrt(10.0));
}

TEST(Bits, AreCounted) {
  EXPECT_EQ(lowest_bit(1), 0);
  EXPECT_EQ(lowest_bit(-6), 1);
  EXPECT_EQ(lowest_bit(smallest), -1074);
  EXPECT_EQ(significant_bits(0), 0);
  EXPECT_EQ(significant_bits(0.75), 2);
  EXPECT_EQ(significant_bits(largest), 53);
  EXPECT_LT(size_of(0.5), size_of(0.75));
  EXPECT_LT(size_of(1), size_of(-1));
  EXPECT_LT(size_of(1), size_of(0x1p-1000));
}

/// The end of a + t (b - a) is lost where b has more than 53 bits below a: of all such inputs one of two powers of two is
/// as small as can be.
TEST(Shrink, LeavesWhatMatters) {
  auto input = line({-0x1.123456789abcdp+3, 0x1.fedcba987654p-60}, 1);
  shrink(input, 1000, [](const Case<double>& candidate, Case<double>& current) {
    if (size_of(candidate, false, false) >= size_of(current, false, false)) return false;
    const auto found = excess(Property::ends_exact, "de_casteljau_lerp", candidate);
    if (!found || *found <= 0) return false;
    current = candidate;
    return true;
  });
  EXPECT_EQ(significant_bits(input(0, 0)), 1);
  EXPECT_EQ(significant_bits(input(0, 1)), 1);
}

/// What is proved holds for special inputs, whatever else the study tries.
template <class Scalar>
void expect_proved_holds() {
  for (const auto& kernel : kernels<Scalar>(2)) {
    if (kernel.info->form != Form::bernstein || guarantees_of(*kernel.info).empty()) continue;
    Evaluation<Scalar> evaluation(kernel);
    for (const auto& statement : statements<Scalar>)
      for (const int degree : {1, 2, 3, 7}) {
        if (!is_proved(*kernel.info, statement.property, degree)) continue;
        sample::Words words(1, 2, static_cast<std::uint64_t>(degree), 4);
        Draws<Scalar> draws(words);
        Case<Scalar> input{2, std::vector<Scalar>(static_cast<std::size_t>(degree) * 2 + 2), 0, 0, 0};
        for (int k = 0; k < 2000; ++k) {
          draws.special(input, statement.axes(2));
          statement.fit(input);
          const auto found = statement.excess(evaluation, input);
          ASSERT_FALSE(found && *found > 0) << kernel.info->id << ' ' << name(statement.property) << ' ' << degree;
        }
      }
  }
}
TEST(Guarantees, HoldForSpecialInputs) {
  expect_proved_holds<double>();
  expect_proved_holds<float>();
}

TEST(Guarantees, AreFoundByTheMethod) {
  const auto& two_sided = *find_kernel<double>("de_casteljau_two_sided", Form::bernstein, 1)->info;
  EXPECT_TRUE(is_proved(two_sided, Property::in_hull, 10));
  EXPECT_TRUE(is_proved(two_sided, Property::monotone, 1));
  EXPECT_FALSE(is_proved(two_sided, Property::monotone, 2));
  EXPECT_FALSE(is_proved(two_sided, Property::in_hull, 0));
  EXPECT_FALSE(is_proved(two_sided, Property::reversal, 1));
  EXPECT_TRUE(guarantees_of(*find_kernel<double>("de_casteljau_two_sided", Form::rational, 1)->info).empty());
  EXPECT_TRUE(guarantees_of(*find_kernel<double>("exact:correctly_rounded", Form::bernstein, 1)->info).empty());
}

}  // namespace
}  // namespace bezierbench::guarantees
