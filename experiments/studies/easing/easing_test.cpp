// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/easing/kernel.hpp"
#include "experiments/studies/easing/problem.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_easing_study() {
  auto study = small_study("easing");
  study.degree = {3};
  study.trials = 80;
  return study;
}

TEST(EasingStudy, OnlyTheCorrectlyRoundedMethodMisroundsNothing) {
  for (const auto* generator : {"continuous", "integer"}) {
    auto study = small_easing_study();
    study.generator = {generator};
    const auto csv = rows_of(study, "easing.csv");
    ASSERT_EQ(csv.row_count(), 5U);
    for (std::size_t row = 0; row < csv.row_count(); ++row) {
      const bool is_exact = csv.at(row, "method") == "easing_correctly_rounded";
      for (const std::string scalar : {"", "float_"}) {
        EXPECT_EQ(csv.at(row, scalar + "misrounded") == "0", is_exact) << csv.at(row, "method") << " " << scalar;
        if (!is_exact) continue;
        EXPECT_LE(run::number_at(csv, row, scalar + "max_error_ulp"), 0.5);
        EXPECT_EQ(csv.at(row, scalar + "non_monotone"), "0");
        EXPECT_EQ(csv.at(row, scalar + "wrong_ends"), "0");
      }
      EXPECT_EQ(csv.at(row, "wrong_outside"), "0");
      EXPECT_EQ(csv.at(row, "not_converged"), "0");
      EXPECT_GT(run::number_at(csv, row, "monotone_trials"), 0);
    }
  }
}

/// A method that promises to be correctly rounded, and is one ulp off.
TEST(EasingStudy, AMisroundedAnswerBreaksThePromise) {
  const auto study = small_easing_study();
  const judge::TrialPart part{sample::cells(study).front(), {}};
  const EasingProblem problem(study, 1, part);
  EasingProblem::Drawn drawn;
  problem.draw(0, drawn);
  const auto& kernel = EasingProblem::kernels(2).front();
  ASSERT_TRUE(kernel.is_correctly_rounded);
  EasingAnswer answer;
  EasingProblem::ask(kernel, drawn, 0, answer);
  const auto broken = [&] {
    EasingErrors errors;
    EasingProblem::judge(kernel, drawn, 0, answer, 7, errors);
    return errors.in_double.broken.count;
  };
  EXPECT_EQ(broken(), 0U);
  answer.eased.front().y = std::nextafter(answer.eased.front().y, 2);
  EXPECT_EQ(broken(), 1U);
  answer.eased.front().y = drawn.nearest;
  answer.eased.back().y = std::nextafter(1.0, 0);
  EXPECT_EQ(broken(), 1U);
}

/// A method that stays at the ends, as if x were clamped to [0, 1].
TEST(EasingStudy, AMethodThatLeavesTheLinesIsCounted) {
  const EasingProblem problem(small_easing_study(), 1, {sample::cells(small_easing_study()).front(), {}});
  EasingProblem::Drawn drawn;
  problem.draw(0, drawn);
  auto kernel = EasingProblem::kernels(2).front();
  EasingAnswer answer;
  EasingProblem::ask(kernel, drawn, 0, answer);
  const auto wrong = [&] {
    EasingErrors errors;
    EasingProblem::judge(kernel, drawn, 0, answer, 7, errors);
    return std::pair(errors.in_double.wrong_outside.count, errors.in_float.wrong_outside.count);
  };
  EXPECT_EQ(wrong(), (std::pair<std::uint64_t, std::uint64_t>(0, 0)));
  kernel.ease = [](const EasingCurve<double>& /*curve*/, std::span<const double> x, Eased<double>* answers) {
    for (const double one : x) *answers++ = {0, one < 0 ? 0.0 : 1.0};
  };
  EXPECT_EQ(wrong(), (std::pair<std::uint64_t, std::uint64_t>(1, 0)));
}

TEST(EasingStudy, RefusesWhatIsNoEasingCurve) {
  auto floats = small_study("easing_floats");
  take_named(floats, {"wilkinson_3"});
  EXPECT_THROW(make_job(floats, {1}), Failure);
}

/// What the rows of easing_floats.csv say, from integers.
TEST(EasingFloats, RowsAreWhatTheIntegersSay) {
  auto study = small_study("easing_floats");
  study.t_interval = {{0x1.fffp-2, 0x1.001p-1}};
  take_named(study, {"css_ease", "easing_1_0_0_1"});
  const auto csv = rows_of(study, "easing_floats.csv");
  ASSERT_EQ(csv.row_count(), 10U);
  const std::map<std::string, EasingCurve<float>, std::less<>> curves{{"css_ease", {0.25F, 0.1F, 0.25F, 1}},
                                                                      {"easing_1_0_0_1", {1, 0, 0, 1}}};
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    const auto& c = curves.find(csv.at(row, "curve_id"))->second;
    const auto& kernel =
        *std::ranges::find_if(easing_kernels(), [&](const auto& one) { return one.info->id == csv.at(row, "method"); });
    std::uint64_t misrounded = 0;
    std::uint64_t back = 0;
    std::uint64_t count = 0;
    double largest = 0;
    float before = 0;
    for (float x = 0x1.fffp-2F; x <= 0x1.001p-1F; x = std::nextafter(x, 1.0F), ++count) {
      Eased<float> eased;
      kernel.ease_float(c, std::span(&x, 1), &eased);
      reference::ExactEased exact(c.x1, c.y1, c.x2, c.y2, x);
      misrounded += exact.nearest(reference::binary32) == eased.y ? 0 : 1;
      largest = std::max(largest, exact.error_ulp(eased.y, reference::binary32));
      back += eased.y < before ? 1 : 0;
      before = eased.y;
    }
    const auto what = std::string(csv.at(row, "curve_id")) + " " + std::string(csv.at(row, "method"));
    EXPECT_EQ(run::number_at(csv, row, "points"), static_cast<double>(count)) << what;
    EXPECT_EQ(run::number_at(csv, row, "misrounded"), static_cast<double>(misrounded)) << what;
    EXPECT_EQ(run::number_at(csv, row, "non_monotone"), static_cast<double>(back)) << what;
    EXPECT_NEAR(run::number_at(csv, row, "max_error_ulp"), largest, 1e-6 * largest) << what;
  }
}

}  // namespace
}  // namespace bezierbench::studies
