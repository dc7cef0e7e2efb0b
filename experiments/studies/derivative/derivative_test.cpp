// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "core/derivative/kernel.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_derivative_study() {
  auto study = small_study("derivative");
  study.order = {1, 2, 5};
  study.degree = {3, 20};
  study.trials = 600;
  study.replicates = 2;
  return study;
}

std::size_t methods_of(Form form) {
  return static_cast<std::size_t>(std::ranges::count(derivative_kernels(2), form,
                                                     [](const DerivativeKernel& kernel) { return kernel.info->form; }));
}

TEST(DerivativeStudy, BoundsHoldAndTheSeedDocumentIsRightForOrderOneOnly) {
  const auto csv = rows_of(small_derivative_study(), "derivative.csv");
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
  const auto csv = rows_of(study, "derivative.csv");
  ASSERT_EQ(csv.row_count(), 2 * 3 * methods_of(Form::power));
  EXPECT_EQ(csv.at(0, "method"), "power_derivative");
}

}  // namespace
}  // namespace bezierbench::studies
