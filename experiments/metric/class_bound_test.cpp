// SPDX-License-Identifier: MIT
#include "experiments/metric/class_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace bezierbench::metric {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;

ErrorBound bound_of(Amplification kind, double result_roundings = 0) {
  return {.text = "",
          .amplification = kind,
          .factor = [](int n, double) { return 3.0 * n; },
          .underflow = [](int n) { return 7.0 * n; },
          .underflow_scales_with_coefficients = true,
          .result_roundings = result_roundings};
}

TEST(ClassBound, IsTheFactorWhereTheBoundIsInTermsOfPTilde) {
  const auto bound = class_bound(bound_of(Amplification::p_tilde_bernstein), {Form::bernstein, 2, 5, 10, 0, 1},
                                 reference::double_arithmetic);
  EXPECT_DOUBLE_EQ(bound.in_u, 15);
  EXPECT_DOUBLE_EQ(bound.coordinate, 15 * u * 10 * std::sqrt(2.0));  // all control points in one corner
  const auto power =
      class_bound(bound_of(Amplification::p_tilde_power), {Form::power, 1, 2, 10, -3, 2}, reference::double_arithmetic);
  EXPECT_DOUBLE_EQ(power.coordinate, 6 * u * 10 * (1 + 3 + 9));  // at t = -3
}

/// sum c_i C(n,i) x^i (1+x)^(n-i) over p~: ((1+t)/(1-t))^n, by the first control point alone.
TEST(ClassBound, OfADetourThroughPowerFormEndsShortOfOne) {
  const auto bound = bound_of(Amplification::bernstein_to_power, 1);
  const auto half = class_bound(bound, {Form::bernstein, 1, 2, 10, 0, 0.5}, reference::double_arithmetic);
  EXPECT_DOUBLE_EQ(half.in_u, 1 + 6 * 9);                    // ((1 + 1/2) / (1 - 1/2))^2
  EXPECT_DOUBLE_EQ(half.coordinate, (10 + 6 * 10 * 4) * u);  // (1 + 2 t)^2 at t = 1/2
  for (const double t_max : {1.0, 3.0}) {
    const auto whole = class_bound(bound, {Form::bernstein, 1, 2, 10, 0, t_max}, reference::double_arithmetic);
    EXPECT_EQ(whole.in_u, infinite);
    EXPECT_TRUE(std::isfinite(whole.coordinate));
  }
}

TEST(ClassBound, IsInfiniteWhereNothingIsProved) {
  auto bound = bound_of(Amplification::p_tilde_bernstein);
  bound.growth = [](int n) { return std::ldexp(1.0, n); };  // 2^5 1e307 and 2^5 1e38 leave the range
  EXPECT_EQ(class_bound(bound, {Form::rational, 2, 5, 10, 0, 1}, reference::double_arithmetic).coordinate, infinite);
  EXPECT_EQ(class_bound(bound, {Form::bernstein, 2, 5, 1e307, 0, 1}, reference::double_arithmetic).coordinate,
            infinite);
  EXPECT_EQ(class_bound(bound, {Form::bernstein, 2, 5, 1e38, 0, 1}, reference::float_arithmetic).coordinate, infinite);
  EXPECT_EQ(class_bound(bound, {Form::bernstein, 2, 1023, 2, 0, 1}, reference::double_arithmetic).in_u, infinite);
  bound.unit_interval_only = true;
  EXPECT_EQ(class_bound(bound, {Form::bernstein, 2, 5, 10, -10, 10}, reference::double_arithmetic).in_u, infinite);
  EXPECT_DOUBLE_EQ(class_bound(bound, {Form::bernstein, 2, 5, 10, 0, 1}, reference::double_arithmetic).in_u, 15);
  bound.factor = [](int, double) { return infinite; };
  EXPECT_EQ(class_bound(bound, {Form::bernstein, 2, 5, 10, 0, 1}, reference::double_arithmetic).in_u, infinite);
}

/// A curve of the class: some coefficients at the ends of the range, some 0, some small, some anywhere.
std::vector<double> member(std::mt19937_64& random, const CurveClass& of) {
  std::vector<double> coefficients(static_cast<std::size_t>((of.degree + 1) * of.dimension));
  for (auto& value : coefficients) {
    const double share = std::ldexp(static_cast<double>(random() >> 11), -52) - 1;
    const double sizes[]{of.range, 0, of.range * 0x1p-40, of.range * std::abs(share)};
    value = std::copysign(sizes[random() % 4], share);
  }
  return coefficients;
}

/// Also near the places where an amplification has its extremes.
double parameter(std::mt19937_64& random, const CurveClass& of) {
  const double share = std::ldexp(static_cast<double>(random() >> 11), -53);
  const double places[]{of.t_min, of.t_max, 0, 1, 0.5, 0x1p-30, 1 - 0x1p-30, of.t_min + share * (of.t_max - of.t_min)};
  return std::clamp(places[random() % 8], of.t_min, of.t_max);
}

/// 200 members of this class.
void expect_it_holds(const ErrorBound& bound, CurveClass of, std::mt19937_64& random) {
  reference::TrialScale scale;
  for (int trial = 0; trial < 200; ++trial) {
    of.degree = static_cast<int>(random() % 12);
    const auto proved = class_bound(bound, of, reference::double_arithmetic);
    const auto curve = member(random, of);
    scale.set({of.form, of.dimension, of.degree, curve}, parameter(random, of));
    const double own = scale.bound(bound, reference::double_arithmetic);
    EXPECT_LE(own, proved.coordinate * (1 + 0x1p-20));
    if (scale.p_tilde() < min_p_tilde(of, reference::double_arithmetic)) continue;
    EXPECT_LE(scale.in_bound_units(own, reference::double_arithmetic), proved.in_u * (1 + 0x1p-20))
        << "amplification " << static_cast<int>(bound.amplification) << ", degree " << of.degree << ", t in ["
        << of.t_min << ", " << of.t_max << "]";
  }
}

/// No curve of the class has a larger bound, whatever the amplification and the interval.
TEST(ClassBound, HoldsForEveryMember) {
  using enum Amplification;
  std::mt19937_64 random(1);
  const std::vector<std::pair<Form, std::vector<Amplification>>> stated{
      {Form::bernstein,
       {p_tilde_bernstein, bernstein_to_power, bernstein_to_centered, spread, spread_to_power,
        spread_to_power_from_start}},
      {Form::power, {p_tilde_power, power_to_bernstein, forward_substitution}}};
  const std::vector<std::pair<double, double>> intervals{{0, 1},     {0.2, 0.8}, {0, 0.5}, {-10, 10},
                                                         {-1, 0.25}, {1.5, 2},   {0, 0},   {-2, -1}};
  for (const auto& [form, kinds] : stated)
    for (const auto kind : kinds)
      for (const auto& [t_min, t_max] : intervals)
        for (const double result_roundings : {0.0, 1.0})
          expect_it_holds(bound_of(kind, result_roundings), {form, 2, 0, 10, t_min, t_max}, random);
}

/// What underflow loses is in the bound down to the least p~, and matters only there.
TEST(ClassBound, CountsUnderflow) {
  const CurveClass of{Form::bernstein, 1, 3, 1e-250, 0, 1};
  const auto bound = class_bound(bound_of(Amplification::p_tilde_bernstein), of, reference::double_arithmetic);
  EXPECT_GT(bound.in_u, 1e50);  // p~ may be 1e-400
  EXPECT_DOUBLE_EQ(bound.coordinate, 9 * u * 1e-250);
}

}  // namespace
}  // namespace bezierbench::metric
