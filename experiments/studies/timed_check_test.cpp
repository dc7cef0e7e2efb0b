// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_check.hpp"

#include <gtest/gtest.h>

namespace bezierbench::studies {
namespace {

timing::Inputs cubic_inputs(Form form = Form::bernstein) {
  timing::Inputs inputs{form, 2, 3, {}, {}, {}};
  for (int k = 0; k < 7; ++k) {
    inputs.curves.push_back({0, 0, 1.0 + k, 2, 3, -1, 4, 0.5});
    inputs.weights.push_back({1, 2, 0.5, 3.0 + k});
    inputs.t.push_back((k + 0.5) / 7);
  }
  return inputs;
}

TEST(TimedCheck, PassesEveryMethodOfTheRosterOnCurvesOfItsForm) {
  for (const auto mode : {suite::Mode::one_shot, suite::Mode::point})
    for (const auto& kernel : kernels<double>(2)) {
      EXPECT_TRUE(agrees_with_reference(kernel, mode, cubic_inputs(kernel.info->form))) << kernel.info->id;
      if (kernel.info->form == Form::rational) continue;  // reads weights, which the others do not have
      const Form other = kernel.info->form == Form::power ? Form::bernstein : Form::power;
      EXPECT_FALSE(agrees_with_reference(kernel, mode, cubic_inputs(other))) << kernel.info->id;
    }
}

TEST(TimedCheck, CatchesAMethodThatLooksAtNoWeights) {
  const auto& wrong = *find_kernel<double>("de_casteljau", Form::bernstein, 2);
  EXPECT_FALSE(agrees_with_reference(wrong, suite::Mode::point, cubic_inputs(Form::rational)));
}

TEST(TimedCheck, CatchesAWrongMethod) {
  Kernel<double> wrong = *find_kernel<double>("de_casteljau", Form::bernstein, 2);
  wrong.evaluate = [](const void*, std::span<const double> t, double* points) {
    for (std::size_t k = 0; k < 2 * t.size(); ++k) points[k] = 1;
  };
  EXPECT_FALSE(agrees_with_reference(wrong, suite::Mode::point, cubic_inputs()));
}

TEST(TimedCheck, CatchesNotANumber) {
  Kernel<double> wrong = *find_kernel<double>("de_casteljau", Form::bernstein, 2);
  wrong.evaluate = [](const void*, std::span<const double> t, double* points) {
    for (std::size_t k = 0; k < 2 * t.size(); ++k) points[k] = std::numeric_limits<double>::infinity();
  };
  EXPECT_FALSE(agrees_with_reference(wrong, suite::Mode::point, cubic_inputs()));
}

}  // namespace
}  // namespace bezierbench::studies
