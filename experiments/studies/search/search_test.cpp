// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/judge/input_fields.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/point_judge.hpp"
#include "experiments/studies/search/climb.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_search_study() {
  auto study = small_study("search", {"de_casteljau*", "horner_bernstein", "direct_pow"});
  study.budget = 1500;
  study.degree = {5};
  study.trials = 300;
  return study;
}

TEST(Search, StaysBetweenTheSampleAndTheBound) {
  const auto table = rows_of(small_search_study(), "search.csv");
  ASSERT_GT(table.row_count(), 4U);
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    EXPECT_NE(table.at(row, "method"), "direct_pow");  // nobody else could replay it
    EXPECT_LE(run::number_at(table, row, "sampled_error_u"), run::number_at(table, row, "searched_error_u"));
    if (table.at(row, "bound_u").empty()) continue;
    EXPECT_LE(run::number_at(table, row, "searched_error_u"), run::number_at(table, row, "bound_u"));
  }
}

/// a + t (b - a) has no bound in u p~: a tiny b beside a large a is all it takes.
TEST(Search, FindsWhatSamplingDoesNot) {
  auto study = small_search_study();
  study.methods = {"de_casteljau_lerp"};
  study.budget = 10000;
  const auto table = rows_of(study, "search.csv");
  EXPECT_GT(run::number_at(table, 0, "searched_error_u"), 50 * run::number_at(table, 0, "sampled_error_u"));
  EXPECT_EQ(table.at(0, "status"), "reached");
}

/// The recorded inputs give the recorded errors, judged afresh.
void expect_replay(const suite::Study& study) {
  const auto table = rows_of(study, "search.csv");
  ASSERT_GT(table.row_count(), 0U);
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto* kernel = find_kernel<double>(table.at(row, "method"), study.form, 2);
    ASSERT_NE(kernel, nullptr);
    sample::Cell cell;
    cell.form = study.form;
    cell.degree = 5;
    const auto trial =
        judge::parse_input({table.at(row, "t"), table.at(row, "coefficients"), table.at(row, "weights")}, cell);
    ASSERT_TRUE(trial);
    judge::TrialInputs<double> inputs(study.form, cell);
    inputs.assign(*trial);
    judge::PointJudge<double> judge;
    EXPECT_EQ(judge.judge(*kernel, inputs).error_u, run::number_at(table, row, "searched_error_u"));
  }
}

TEST(Search, RowsCanBeReplayed) {
  expect_replay(small_search_study());
  auto rational = small_search_study();
  rational.form = Form::rational;
  rational.generator = {"weights_mild"};
  rational.methods = {"de_casteljau*", "wozny_chudy"};
  expect_replay(rational);
}

TEST(InputFields, AreReadBackOrRefused) {
  sample::Cell cell;
  cell.form = Form::rational;
  cell.degree = 1;
  const sample::Trial trial{{1, 2, -3, 0.1}, 0.25, {0.5, 3}};
  const auto fields = judge::input_fields(trial, 2);
  EXPECT_EQ(fields,
            (std::vector<std::string>{"0x1p-2", "0x1p+0 -0x1.8p+1 0x1p+1 0x1.999999999999ap-4", "0x1p-1 0x1.8p+1"}));
  const auto read = judge::parse_input({fields[0], fields[1], fields[2]}, cell);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->coefficients, trial.coefficients);
  EXPECT_EQ(read->weights, trial.weights);
  EXPECT_EQ(read->t, trial.t);
  for (const std::string weights : {"", "1", "1 2 3", "1 nan", "1 2 ", " 1 2", "1  2"})
    EXPECT_FALSE(judge::parse_input({fields[0], fields[1], weights}, cell)) << weights;
  cell.form = Form::bernstein;
  EXPECT_FALSE(judge::parse_input({fields[0], fields[1], fields[2]}, cell));
  EXPECT_TRUE(judge::parse_input({fields[0], fields[1], ""}, cell));
}

TEST(Climb, StaysInTheBox) {
  sample::Cell cell;
  cell.degree = 3;
  cell.coordinate_range = 3;
  cell.t_interval = {0.25, 0.75};
  const Climb climb(cell, 0);
  sample::Words words(1, 2, 3, 4);
  sample::Trial trial{{0, 1, 2, 3, -3, -2, -1, 0}, 0.5, {0.75, 1, 1.5, 0.5}};
  bool moved = false;
  for (int step = 0; step < 20000; ++step) {
    const double before = trial.t;
    climb.step(words, trial);
    moved = moved || trial.t != before;
    ASSERT_GE(trial.t, 0.25);
    ASSERT_LE(trial.t, 0.75);
    for (const double value : trial.coefficients) ASSERT_LE(std::abs(value), 3);
    for (const double weight : trial.weights) {
      ASSERT_GE(weight, 0.5);
      ASSERT_LT(weight, 2);
    }
  }
  EXPECT_TRUE(moved);
}

}  // namespace
}  // namespace bezierbench::studies
