// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "core/derivative/kernel.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_derivative_study() {
  suite::Study study;
  study.id = "small";
  study.kind = &kind("derivative");
  study.order = {1, 2, 5};
  study.degree = {3, 20};
  study.trials = 600;  // two blocks, the last one short
  study.replicates = 2;
  return study;
}

std::size_t methods_of(Form form) {
  return static_cast<std::size_t>(std::ranges::count(derivative_kernels(2), form,
                                                     [](const DerivativeKernel& kernel) { return kernel.info->form; }));
}

bundle::CsvDocument derivative_rows_of(const suite::Study& study) {
  const auto job = make_job(study, {1});
  run::run_all(*job);
  return bundle::parse_csv(run::text_of(*job).at("derivative.csv"), "derivative.csv");
}

TEST(DerivativeStudy, OrderAndInterruptionsChangeNoByte) {
  const auto files = run::expect_order_changes_nothing(make_job, small_derivative_study());
  EXPECT_EQ(make_job(small_derivative_study(), {1})->extent().rows,
            bundle::parse_csv(files.at("derivative.csv"), "derivative.csv").row_count());
}

TEST(DerivativeStudy, BoundsHoldAndTheSeedDocumentIsRightForOrderOneOnly) {
  const auto study = small_derivative_study();
  const auto job = make_job(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(job->violations().empty());
  const auto csv = derivative_rows_of(study);
  ASSERT_EQ(csv.row_count(), 2 * 3 * methods_of(Form::bernstein));
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "trials"), "1200");
    EXPECT_EQ(csv.at(row, "non_finite"), "0");
    const bool beyond = run::number_at(csv, row, "order") > run::number_at(csv, row, "degree");
    const bool as_printed = csv.at(row, "method") == "seed_000";
    EXPECT_EQ(csv.at(row, "bound_violations"), as_printed ? "" : "0");
    if (beyond) {
      EXPECT_EQ(csv.at(row, "max_error"), "0");
    } else if (as_printed && run::number_at(csv, row, "order") > 1) {
      EXPECT_GT(run::number_at(csv, row, "mean_error_u"), 1e12);  // about the size of the derivative
    } else if (!as_printed) {
      EXPECT_LE(run::number_at(csv, row, "max_error_u"), run::number_at(csv, row, "bound_u"));
      EXPECT_GT(run::number_at(csv, row, "max_error_u"), 0);
    }
  }
}

/// The same curves are drawn for the power form as for the Bernstein form; only methods for the study's form have rows.
TEST(DerivativeStudy, TakesTheMethodsOfTheForm) {
  auto study = small_derivative_study();
  study.form = Form::power;
  const auto csv = derivative_rows_of(study);
  ASSERT_EQ(csv.row_count(), 2 * 3 * methods_of(Form::power));
  EXPECT_EQ(csv.at(0, "method"), "power_derivative");
}

TEST(DerivativeStudy, RefusesWhatItCannotDo) {
  auto rational = small_derivative_study();
  rational.form = Form::rational;
  EXPECT_THROW(make_job(rational, {1}), Failure);
  auto single = small_derivative_study();
  single.scalar = {suite::ScalarKind::float32};
  EXPECT_THROW(make_job(single, {1}), Failure);
  auto for_points = small_derivative_study();
  for_points.methods = {"de_casteljau"};
  EXPECT_THROW(make_job(for_points, {1}), Failure);
  auto other_form = small_derivative_study();
  other_form.methods = {"power_derivative"};
  EXPECT_THROW(make_job(other_form, {1}), Failure);
}

}  // namespace
}  // namespace bezierbench::studies
