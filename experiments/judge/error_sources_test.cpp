// SPDX-License-Identifier: MIT
#include "experiments/judge/error_sources.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/evaluate/kernel/prepared_state.hpp"

namespace bezierbench::judge {
namespace {

struct Measured {
  double total = 0;
  ErrorSources sources;
};

Measured measured(const Kernel<double>& kernel, const CurveView<double>& curve, double t) {
  std::vector<double> point(static_cast<std::size_t>(curve.dimension));
  PreparedState<double>(kernel, curve).evaluate({&t, 1}, point.data());
  reference::ExactCurve exact;
  const reference::ExactPoint truth = exact.point(curve, t);
  SourceMeter<double> meter;
  const auto sources = meter.measure(kernel, curve, t, point, truth);
  EXPECT_TRUE(sources) << kernel.info->id;
  return {reference::Distance(truth).to(point), sources.value_or(ErrorSources{})};
}

std::vector<double> random_coefficients(std::mt19937_64& bits, int degree, bool integers) {
  std::vector<double> all;
  for (int k = 0; k < 2 * (degree + 1); ++k) {
    const double uniform = static_cast<double>(bits() >> 11U) * 0x1p-52 - 1;
    all.push_back(integers ? std::floor(1000 * uniform) : uniform);
  }
  return all;
}

/// The curve in the form of the kernel; a rational one with weights that rounding moves.
CurveView<double> view(const Kernel<double>& kernel, int degree, const std::vector<double>& coefficients) {
  static const std::vector<double> weights{1, 0.3, 5, 0.7, 1e-3, 2, 1, 40, 0.1, 3};
  CurveView<double> curve{kernel.info->form, 2, degree, coefficients};
  if (curve.form == Form::rational) curve.weights = std::span(weights).first(static_cast<std::size_t>(degree) + 1);
  return curve;
}

/// Every method: the parts explain the whole, and it explains each of them where the others are nothing.
TEST(ErrorSources, AddUpToTheError) {
  constexpr int degree = 9;
  std::mt19937_64 bits(5);
  for (int round = 0; round < 20; ++round) {
    const auto coefficients = random_coefficients(bits, degree, false);
    const double t = static_cast<double>(bits() >> 11U) * 0x1p-53;
    for (const auto& kernel : kernels<double>(2)) {
      const auto [total, s] = measured(kernel, view(kernel, degree, coefficients), t);
      EXPECT_LE(total, (s.conversion + s.one_minus_t + s.evaluation) * (1 + 0x1p-20)) << kernel.info->id;
      EXPECT_TRUE(kernel.converted != nullptr || s.conversion == 0) << kernel.info->id;
      EXPECT_TRUE(kernel.info->one_minus_t != OneMinusT::unused || s.one_minus_t == 0) << kernel.info->id;
    }
  }
}

/// On small integers every conversion to power form is exact; for t in 2^-20 Z so is 1 - t.
TEST(ErrorSources, AreNothingWhereTheStepIsExact) {
  constexpr int degree = 9;
  std::mt19937_64 bits(6);
  for (int round = 0; round < 20; ++round) {
    const auto coefficients = random_coefficients(bits, degree, true);
    const double t = static_cast<double>(bits() >> 44U) * 0x1p-20;
    for (const auto& kernel : kernels<double>(2)) {
      if (kernel.info->form == Form::power) continue;
      const auto sources = measured(kernel, view(kernel, degree, coefficients), t).sources;
      EXPECT_EQ(sources.conversion, 0) << kernel.info->id;
      EXPECT_EQ(sources.one_minus_t, 0) << kernel.info->id;
    }
  }
}

/// b = (0, 1), t = 2^-60: 1 - t rounds to 1. Direct evaluation of b = (1, 0) returns s = 1; the truth is 1 - 2^-60.
TEST(ErrorSources, SeesTheRoundingOfOneMinusT) {
  const std::vector<double> coefficients{1, 0};
  const auto [total, sources] = measured(*find_kernel<double>("de_casteljau", Form::bernstein, 1),
                                         {Form::bernstein, 1, 1, coefficients}, 0x1p-60);
  EXPECT_EQ(total, 0x1p-60);
  EXPECT_EQ(sources.one_minus_t, 0x1p-60);
  EXPECT_EQ(sources.evaluation, 0);
}

/// Likewise with weights 1 and 2: the truth is (1 - 2^-60) / (1 + 2^-60), with 1 for 1 - t it is 1 / (1 + 2^-59).
TEST(ErrorSources, SeesTheRoundingOfOneMinusTInRationalCurves) {
  const std::vector<double> coefficients{1, 0};
  const std::vector<double> weights{1, 2};
  for (const auto* id : {"de_casteljau", "de_casteljau_farin", "wozny_chudy"}) {
    const auto [total, sources] =
        measured(*find_kernel<double>(id, Form::rational, 1), {Form::rational, 1, 1, coefficients, weights}, 0x1p-60);
    EXPECT_EQ(total, 0x1p-59) << id;                 // 1 is returned; to 24 bits
    EXPECT_EQ(sources.one_minus_t, 0x1p-119) << id;  // (1-t)/(1+t) - 1/(1+2t) = -2t^2 / ((1+t)(1+2t))
  }
}

}  // namespace
}  // namespace bezierbench::judge
