// SPDX-License-Identifier: MIT
// A lane of a group has the bits of TrialScale on that trial alone.
#include "experiments/metric/scale_lanes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "reference/error/trial_scale.hpp"

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
  const std::set<Amplification> kinds =
      form == Form::bernstein
          ? std::set{Amplification::p_tilde_bernstein,     Amplification::bernstein_to_power,
                     Amplification::bernstein_to_centered, Amplification::spread,
                     Amplification::spread_to_power,       Amplification::spread_to_power_from_start}
          : std::set{Amplification::p_tilde_power, Amplification::p_tilde_centered, Amplification::power_to_bernstein,
                     Amplification::forward_substitution};
  std::mt19937_64 bits(7);
  ScaleLanes group;
  for (int round = 0; round < 20; ++round) {
    group.begin(dimension, degree);
    std::vector<std::vector<double>> values;
    std::vector<double> t;
    for (std::size_t k = 0; k < reference::certified_lanes; ++k) {
      values.push_back(coefficients(k, static_cast<std::size_t>((degree + 1) * dimension), bits));
      t.push_back(parameter(k, bits));
      group.load(k, {form, dimension, degree, values.back()}, t.back());
    }
    group.compute(kinds);
    for (std::size_t k = 0; k < reference::certified_lanes; ++k) {
      const CurveView<double> curve{form, dimension, degree, values[k]};
      reference::TrialScale alone;
      alone.set(curve, t[k]);
      reference::TrialScale in_group;
      in_group.set(curve, t[k], group.largest(k), group.amplified(k));
      for (const Amplification kind : kinds) {
        const ErrorBound bound{.text = "",
                               .amplification = kind,
                               .factor = [](int n, double) { return n + 1.0; },
                               .underflow = [](int n) { return n + 1.0; },
                               .underflow_scales_with_coefficients = true};
        EXPECT_EQ(in_group.bound(bound, reference::float_arithmetic), alone.bound(bound, reference::float_arithmetic))
            << k;
        EXPECT_EQ(in_group.bound(bound, reference::double_arithmetic), alone.bound(bound, reference::double_arithmetic))
            << k;
      }
      EXPECT_EQ(in_group.p_tilde(), alone.p_tilde()) << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ScaleLanesOf,
                         testing::Values(Setting{Form::bernstein, 2, 20}, Setting{Form::bernstein, 1, 0},
                                         Setting{Form::bernstein, 2, 100}, Setting{Form::power, 2, 420},
                                         Setting{Form::bernstein, 3, 5}, Setting{Form::power, 2, 20},
                                         Setting{Form::power, 1, 1}, Setting{Form::power, 3, 0}));

}  // namespace
}  // namespace bezierbench::metric
