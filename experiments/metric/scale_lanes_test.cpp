// SPDX-License-Identifier: MIT
// Lane by lane, what is known has the bits of the scalar functions.
#include "experiments/metric/scale_lanes.hpp"

#include <gtest/gtest.h>

#include <random>

#include "experiments/metric/trial_scale.hpp"

namespace bezierbench::metric {
namespace {

double uniform(std::mt19937_64& bits) { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

/// A curve whose coefficients are ordinary, or leave the range in which squares and powers are safe.
std::vector<double> coefficients(std::size_t lane, std::size_t count, std::mt19937_64& bits) {
  constexpr std::array<int, 8> exponents{0, 20, -399, 0, 450, -600, 0, 700};
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k)
    values.push_back(std::ldexp(2 * uniform(bits) - 1, exponents[lane % exponents.size()]));
  if (lane % 3 == 0) values[lane % count] = 0;
  if (lane == 6) std::fill(values.begin(), values.end(), 0.0);
  return values;
}

double parameter(std::size_t lane, std::mt19937_64& bits) {
  constexpr std::array<double, 6> special{0, 1, 0.5, 0x1p-200, -0.25, 1e30};
  return lane % 2 == 0 ? uniform(bits) : special[lane / 2 % special.size()];
}

struct Setting {
  Form form;
  int dimension;
  int degree;
};

class ScaleLanesOf : public testing::TestWithParam<Setting> {};

TEST_P(ScaleLanesOf, HasTheBitsOfTrialScale) {
  const auto [form, dimension, degree] = GetParam();
  constexpr std::array<Amplification, 3> of_bernstein{
      Amplification::p_tilde_bernstein, Amplification::bernstein_to_power, Amplification::bernstein_to_centered};
  constexpr std::array<Amplification, 3> of_power{Amplification::p_tilde_power, Amplification::power_to_bernstein,
                                                  Amplification::forward_substitution};
  std::mt19937_64 bits(7);
  ScaleLanes group;
  int known = 0;
  for (int round = 0; round < 20; ++round) {
    group.begin(dimension, degree);
    std::vector<std::vector<double>> values;
    std::vector<double> t;
    for (std::size_t k = 0; k < reference::certified_lanes; ++k) {
      values.push_back(coefficients(k, static_cast<std::size_t>((degree + 1) * dimension), bits));
      t.push_back(parameter(k, bits));
      group.load(k, {form, dimension, degree, values.back()}, t.back());
    }
    group.take_norms();
    std::vector<KnownAmplification> amplified;
    for (const auto kind : form == Form::bernstein ? of_bernstein : of_power)
      amplified.push_back({kind, group.amplifications(kind)});
    for (std::size_t k = 0; k < reference::certified_lanes; ++k) {
      const CurveView<double> curve{form, dimension, degree, values[k]};
      TrialScale right;
      right.set(curve, t[k]);
      TrialScale ours;
      ours.set(curve, t[k], group, k, amplified);
      for (const auto& one : amplified) {
        const ErrorBound bound{.text = "",
                               .amplification = one.kind,
                               .factor = [](int n, double) { return n + 1.0; },
                               .underflow = [](int n) { return n + 1.0; },
                               .underflow_scales_with_coefficients = true};
        EXPECT_EQ(ours.bound(bound, float_arithmetic), right.bound(bound, float_arithmetic)) << k;
        EXPECT_EQ(ours.bound(bound, double_arithmetic), right.bound(bound, double_arithmetic)) << k;
        known += group.is_plain(k) && !std::isnan(one.values[k]) ? 1 : 0;
      }
      EXPECT_EQ(ours.p_tilde(), right.p_tilde()) << k;
    }
  }
  EXPECT_GT(known, 200);
}

INSTANTIATE_TEST_SUITE_P(All, ScaleLanesOf,
                         testing::Values(Setting{Form::bernstein, 2, 20}, Setting{Form::bernstein, 1, 0},
                                         Setting{Form::bernstein, 3, 5}, Setting{Form::power, 2, 20},
                                         Setting{Form::power, 1, 1}, Setting{Form::power, 3, 0}));

}  // namespace
}  // namespace bezierbench::metric
