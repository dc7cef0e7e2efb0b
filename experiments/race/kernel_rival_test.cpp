// SPDX-License-Identifier: MIT
#include "experiments/race/kernel_rival.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <type_traits>

#include "experiments/metric/tally.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/requirements/seeded_curves.hpp"

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

/// By the kernel's own functions, one curve and one t at a time.
template <class Scalar>
std::vector<Scalar> judged_points(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs) {
  std::vector<Scalar> points(inputs.t.size() * static_cast<std::size_t>(inputs.dimension));
  for (std::size_t k = 0; k < inputs.t.size(); ++k) {
    const PreparedState<Scalar> prepared(kernel, inputs.curve_of(k, mode));
    prepared.evaluate(std::span<const Scalar>(&inputs.t[k], 1),
                      points.data() + k * static_cast<std::size_t>(inputs.dimension));
  }
  return points;
}

constexpr suite::Mode modes[] = {suite::Mode::one_shot, suite::Mode::point, suite::Mode::latency, suite::Mode::batch};

template <class Scalar>
class KernelRival : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(KernelRival, Scalars);

TYPED_TEST(KernelRival, ReproducesTheJudgedPointsInEveryMode) {
  for (const auto mode : modes)
    for (const auto& kernel : kernels<TypeParam>(2)) {
      const auto inputs = cubic_inputs<TypeParam>(kernel.info->form);
      const Rival rival = kernel_rival(kernel, mode, inputs, judged_points(kernel, mode, inputs));
      EXPECT_EQ(rival.points_per_batch, 7U);
      EXPECT_FALSE(rival.check()) << "nothing ran yet";
      rival.run();
      EXPECT_TRUE(rival.check()) << kernel.info->id;
      EXPECT_FALSE(rival.check()) << "a check clears the points: the next round must write them again";
    }
}

TYPED_TEST(KernelRival, IsHeldToTheLastBit) {
  const auto inputs = cubic_inputs<TypeParam>(Form::bernstein);
  const auto& kernel = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  for (const auto mode : modes)
    for (std::size_t k = 0; k < 2 * inputs.t.size(); ++k) {
      auto judged = judged_points(kernel, mode, inputs);
      judged[k] = std::nextafter(judged[k], std::numeric_limits<TypeParam>::infinity());
      const Rival rival = kernel_rival(kernel, mode, inputs, judged);
      rival.run();
      EXPECT_FALSE(rival.check());
    }
}

/// The dependence on the last point must not change a t: not after NaN, not after an infinity, not for t = -0.
TYPED_TEST(KernelRival, LatencyHandsOnWhatIsNoNumber) {
  Kernel<TypeParam> echo = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  echo.evaluator = nullptr;  // that no batch kernel may take its place
  echo.evaluate_for = [](int) -> EvaluatePoints<TypeParam> {
    return [](const void*, std::span<const TypeParam> t, TypeParam* points) {
      points[0] = t[0];
      points[1] = t[0] > TypeParam(0.5) ? std::numeric_limits<TypeParam>::quiet_NaN()
                                        : -std::numeric_limits<TypeParam>::infinity();
    };
  };
  auto inputs = cubic_inputs<TypeParam>(Form::bernstein);
  inputs.t[3] = -TypeParam(0);
  const Rival rival = kernel_rival(echo, suite::Mode::latency, inputs, judged_points(echo, suite::Mode::point, inputs));
  rival.run();
  EXPECT_TRUE(rival.check());
}

/// A round gives each rival 50 us; all inputs of a method that takes 20 us each would take 5 ms.
TYPED_TEST(KernelRival, OneShotsOfASlowMethodFillATurn) {
  Kernel<TypeParam> slow = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  Inputs<TypeParam> inputs{Form::bernstein, 2, 1, {}, {}, {}};
  for (int k = 0; k < 256; ++k) {
    inputs.curves.push_back({0, 0, TypeParam(k), 1});
    inputs.t.push_back(TypeParam(0.5));
  }
  const auto judged = judged_points(slow, suite::Mode::one_shot, inputs);
  const auto inputs_of = [&](suite::Mode mode) { return kernel_rival(slow, mode, inputs, judged).points_per_batch; };
  EXPECT_EQ(inputs_of(suite::Mode::one_shot), 256U);
  static const auto prepare = slow.prepare;
  slow.prepare = [](const CurveView<TypeParam>& curve, void* prepared) {
    for (const auto start = steady_ns(); steady_ns() - start < 20'000;) {
    }
    prepare(curve, prepared);
  };
  EXPECT_EQ(inputs_of(suite::Mode::point), 256U);
  const Rival rival = kernel_rival(slow, suite::Mode::one_shot, inputs, judged);
  EXPECT_EQ(rival.points_per_batch, 8U);
  EXPECT_FALSE(rival.check()) << "the points of the measurement are not a result";
  rival.run();
  EXPECT_TRUE(rival.check());
}

int alive = 0;  ///< objects that the kernel below prepared and not yet destroyed

/// A library's object owns memory: each must end once, however often another curve takes its place.
TYPED_TEST(KernelRival, EndsWhatItPrepared) {
  Kernel<TypeParam> owner = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  owner.evaluator = nullptr;
  owner.prepare = [](const CurveView<TypeParam>&, void*) { ++alive; };
  owner.evaluate_for = [](int) -> EvaluatePoints<TypeParam> {
    return [](const void*, std::span<const TypeParam>, TypeParam*) { EXPECT_EQ(alive, 1); };
  };
  owner.destroy = [](void*) { --alive; };
  const auto inputs = cubic_inputs<TypeParam>(Form::bernstein);
  for (const auto mode : modes) {
    {
      const Rival rival = kernel_rival(owner, mode, inputs, std::vector<TypeParam>(2 * inputs.t.size()));
      rival.run();
      rival.run();
      EXPECT_EQ(alive, 1);
    }
    EXPECT_EQ(alive, 0);
  }
}

/// Where what a batch touches lies within its page: the prepared state, t, the points.
std::vector<std::array<std::uintptr_t, 3>> touched;

/// The allocator must not decide which of two rivals is the faster.
TYPED_TEST(KernelRival, LiesInItsPagesAsEveryOtherDoes) {
  Kernel<TypeParam> watched = *find_kernel<TypeParam>("de_casteljau", Form::bernstein, 2);
  watched.evaluator = nullptr;
  watched.evaluate_for = [](int) -> EvaluatePoints<TypeParam> {
    return [](const void* prepared, std::span<const TypeParam> t, TypeParam* points) {
      const auto place = [](const void* address) { return reinterpret_cast<std::uintptr_t>(address) % page; };
      touched.push_back({place(prepared), place(t.data()), place(points)});
    };
  };
  const auto inputs = cubic_inputs<TypeParam>(Form::bernstein);
  const std::vector<TypeParam> judged(2 * inputs.t.size());
  std::vector<Rival> rivals;
  std::vector<std::unique_ptr<std::byte[]>> between;  // odd amounts of memory
  for (std::size_t k = 0; k < 20; ++k) {
    rivals.push_back(kernel_rival(watched, suite::Mode::batch, inputs, judged));
    between.push_back(std::make_unique<std::byte[]>(100 * k + 1));
  }
  touched.clear();
  for (const auto& rival : rivals) rival.run();
  ASSERT_EQ(touched.size(), rivals.size());
  for (const auto& places : touched) EXPECT_EQ(places, touched.front());
  const std::set<std::uintptr_t> distinct(touched.front().begin(), touched.front().end());
  EXPECT_EQ(distinct.size(), 3U) << "a load must not wait for a store to other data";
}

TYPED_TEST(KernelRival, ACallCopiesTheParameter) {
  for (const auto mode : modes)
    for (const auto form : {Form::bernstein, Form::rational}) {
      const auto inputs = cubic_inputs<TypeParam>(form);
      const Rival rival = call_rival(mode, inputs);
      EXPECT_EQ(rival.points_per_batch, 7U);
      EXPECT_FALSE(rival.check()) << "nothing ran yet";
      rival.run();
      EXPECT_TRUE(rival.check());
      EXPECT_FALSE(rival.check()) << "a check uses the points up";
    }
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
