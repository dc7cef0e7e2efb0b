// SPDX-License-Identifier: MIT
#include "experiments/race/timed_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "experiments/metric/observed_error.hpp"

namespace bezierbench::race {
namespace {

template <class Scalar>
Inputs<Scalar> cubic_inputs(Form form) {
  Inputs<Scalar> inputs{form, 2, 3, {}, {}, {}};
  for (int k = 0; k < 7; ++k) {
    inputs.curves.push_back({0, 0, Scalar(1) + Scalar(k), 2, 3, -1, 4, Scalar(0.5)});
    inputs.weights.push_back({1, 2, Scalar(0.5), Scalar(3) + Scalar(k)});
    inputs.t.push_back((Scalar(k) + Scalar(0.5)) / 7);
  }
  return inputs;
}

/// Right as far as the check says, and near enough where no bound is proved and no accuracy study says more.
template <class Scalar>
bool is_right(const JudgedPoints<Scalar>& judged) {
  const double u = std::numeric_limits<Scalar>::epsilon() / 2;
  return judged.right && judged.max_error_u.value_or(0) <= metric::allowed_error_u(std::nullopt, u);
}

template <class Scalar>
class TimedCheck : public testing::Test {
 protected:
  /// de Casteljau with another function in place of its own.
  template <EvaluatePoints<Scalar> evaluate>
  static Kernel<Scalar> with() {
    Kernel<Scalar> kernel = *find_kernel<Scalar>("de_casteljau", Form::bernstein, 2);
    kernel.evaluate_for = for_every_degree<Scalar, evaluate>;
    return kernel;
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TimedCheck, Scalars);

TYPED_TEST(TimedCheck, PassesEveryMethodOfTheRosterOnCurvesOfItsForm) {
  for (const auto mode : {suite::Mode::one_shot, suite::Mode::point})
    for (const auto& kernel : kernels<TypeParam>(2)) {
      const Form form = kernel.info->form;
      EXPECT_TRUE(is_right(judge_points(kernel, mode, cubic_inputs<TypeParam>(form)))) << kernel.info->id;
      if (form == Form::rational) continue;  // reads weights, which the others do not have
      const Form other = form == Form::power ? Form::bernstein : Form::power;
      EXPECT_FALSE(is_right(judge_points(kernel, mode, cubic_inputs<TypeParam>(other)))) << kernel.info->id;
    }
}

/// Curves of that degree on one axis.
template <class Scalar>
Inputs<Scalar> inputs_of(int degree) {
  Inputs<Scalar> inputs{Form::bernstein, 1, degree, {}, {}, {}};
  for (int k = 0; k < 16; ++k) {
    std::vector<Scalar> curve;
    for (int i = 0; i <= degree; ++i) curve.push_back(Scalar((7 * i + k) % 5) - Scalar(2));
    inputs.curves.push_back(curve);
    inputs.weights.emplace_back();
    inputs.t.push_back((Scalar(k) + Scalar(0.5)) / 16);
  }
  return inputs;
}

/// Interpolation at uniform nodes has lost all digits of float there, which an accuracy study shows.
TYPED_TEST(TimedCheck, SaysHowMuchTheLeastStableOfAllLosesAtAHighDegree) {
  const auto& kernel = *find_kernel<TypeParam>("barycentric_uniform", Form::bernstein, 1);
  const auto judged = judge_points(kernel, suite::Mode::one_shot, inputs_of<TypeParam>(30));
  EXPECT_TRUE(judged.right);
  EXPECT_GT(judged.max_error_u, 1e3);
  EXPECT_LT(judged.max_error_u, 1e9);
  EXPECT_EQ(is_right(judged), (std::is_same_v<TypeParam, double>)) << "half of the digits are left in double only";
}

/// At these degrees 64 (n+1) 2^n u, which it was held to once, lets any number pass.
TYPED_TEST(TimedCheck, CatchesAWrongMethodWithoutABoundAtAHighDegree) {
  static constexpr MethodInfo unproved{.id = "unproved", .label = "", .flops = "", .citation = ""};
  for (const int degree : {15, 42, 60}) {
    Kernel<TypeParam> kernel = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 1);
    kernel.info = &unproved;
    EXPECT_TRUE(is_right(judge_points(kernel, suite::Mode::one_shot, inputs_of<TypeParam>(degree))));
    kernel.evaluate_for = [](int) -> EvaluatePoints<TypeParam> {
      return [](const void* prepared, std::span<const TypeParam> t, TypeParam* points) {
        // The function for max_degree evaluates curves of every degree.
        find_kernel<TypeParam>("de_casteljau", Form::bernstein, 1)->evaluate_for(max_degree)(prepared, t, points);
        points[0] += TypeParam(0.01);
      };
    };
    EXPECT_FALSE(is_right(judge_points(kernel, suite::Mode::one_shot, inputs_of<TypeParam>(degree)))) << degree;
  }
}

TYPED_TEST(TimedCheck, CatchesAMethodThatLooksAtNoWeights) {
  const auto& wrong = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  EXPECT_FALSE(judge_points(wrong, suite::Mode::point, cubic_inputs<TypeParam>(Form::rational)).right);
}

/// At t = 1/2, p = (b_0 + 3 b_1 + 3 b_2 + b_3) / 8, by hand: no rounding.
TYPED_TEST(TimedCheck, HandsOverThePointsThatItJudged) {
  const auto inputs = cubic_inputs<TypeParam>(Form::bernstein);
  const auto& kernel = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  const auto first_curve = judge_points(kernel, suite::Mode::point, inputs).points;
  const auto each_curve = judge_points(kernel, suite::Mode::one_shot, inputs).points;
  ASSERT_EQ(first_curve.size(), 14U);
  EXPECT_EQ(inputs.t[3], TypeParam(0.5));
  EXPECT_EQ(first_curve[6], TypeParam(2));       // (0 + 3 + 9 + 4) / 8
  EXPECT_EQ(first_curve[7], TypeParam(0.4375));  // (0 + 6 - 3 + 0.5) / 8
  EXPECT_EQ(each_curve[6], TypeParam(3.125));    // (0 + 3 * 4 + 9 + 4) / 8
}

template <class Scalar>
void write_ones(const void* /*prepared*/, std::span<const Scalar> t, Scalar* points) {
  std::fill_n(points, 2 * t.size(), Scalar(1));
}

template <class Scalar>
void write_infinities(const void* /*prepared*/, std::span<const Scalar> t, Scalar* points) {
  std::fill_n(points, 2 * t.size(), std::numeric_limits<Scalar>::infinity());
}

TYPED_TEST(TimedCheck, CatchesAWrongMethod) {
  const auto ones = this->template with<write_ones<TypeParam>>();
  EXPECT_FALSE(judge_points(ones, suite::Mode::point, cubic_inputs<TypeParam>(Form::bernstein)).right);
}

TYPED_TEST(TimedCheck, CatchesNotANumber) {
  const auto infinite = this->template with<write_infinities<TypeParam>>();
  EXPECT_FALSE(judge_points(infinite, suite::Mode::point, cubic_inputs<TypeParam>(Form::bernstein)).right);
}

}  // namespace
}  // namespace bezierbench::race
