// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_check.hpp"

#include <gtest/gtest.h>

namespace bezierbench::studies {
namespace {

timing::Inputs cubic_inputs() {
  timing::Inputs inputs{Form::bernstein, 2, 3, {}, {}};
  for (int k = 0; k < 7; ++k) {
    inputs.curves.push_back({0, 0, 1.0 + k, 2, 3, -1, 4, 0.5});
    inputs.t.push_back((k + 0.5) / 7);
  }
  return inputs;
}

TEST(TimedCheck, PassesEveryMethodOfTheRoster) {
  const auto inputs = cubic_inputs();
  for (const auto mode : {suite::Mode::one_shot, suite::Mode::point})
    for (const auto& kernel : kernels<double>(2))
      EXPECT_EQ(agrees_with_reference(kernel, mode, inputs), kernel.info->form == Form::bernstein) << kernel.info->id;
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
