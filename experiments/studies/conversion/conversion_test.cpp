// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/studies/study_test.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

suite::Study conversion_study_of(std::vector<std::string> methods) {
  auto study = small_study("conversion", std::move(methods));
  study.degree = {1, 3, 10};
  study.coordinate_range = {1e6};
  study.trials = 10;
  study.replicates = 3;
  return study;
}

/// Integer control points survive the round trip exactly while the coefficients stay below 2^53.
TEST(Conversion, IntegerPointsComeBackExactly) {
  auto study = conversion_study_of({"factorial+forward_substitution+factorial"});
  study.generator = {"integer"};
  const auto csv = rows_of(study, "conversion.csv");
  ASSERT_EQ(csv.row_count(), 3U);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(csv.at(row, "max_error"), "0");
    EXPECT_EQ(csv.at(row, "trials"), "30");
    EXPECT_EQ(csv.at(row, "within_1e-5"), "30");
  }
}

TEST(Conversion, OneConversionIsJudgedAgainstTheExactOne) {
  const auto csv = rows_of(conversion_study_of({"exact", "factorial"}), "conversion.csv");
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    const double worst = *number::parse_number(csv.at(row, "max_error"));
    // A rounded coefficient is off by half an ulp of at most 3^n 1e6, on each of two axes.
    if (csv.at(row, "conversion") == "exact") {
      EXPECT_LE(worst, 0x1p-53 * 59049 * 1e6 * 1.5);
    }
    EXPECT_GT(worst, 0);
  }
}

TEST(Conversion, AChainMustStartFromTheFormOfTheCurve) {
  EXPECT_THROW(make_job(conversion_study_of({"forward_substitution"}), {1}), Failure);
  EXPECT_THROW(make_job(conversion_study_of({"factorial+factorial"}), {1}), Failure);
}

TEST(Conversion, SaysWhereADegreeIsNotSupported) {
  auto study = conversion_study_of({"factorial"});
  study.degree = {171};
  const auto csv = rows_of(study, "conversion.csv");
  EXPECT_EQ(csv.at(0, "status"), "degree_unsupported");
  EXPECT_EQ(csv.at(0, "mean_error"), "");
}

TEST(Conversion, TheOrderOfBlocksChangesNothing) {
  const auto study = conversion_study_of({"factorial", "factorial+forward_substitution"});
  EXPECT_EQ(run::expect_order_changes_nothing(make_job, study).size(), 1U);
}

TEST(Conversion, CountsAreSummedOverDegrees) {
  const auto job = make_job(conversion_study_of({"exact"}), {1});
  run::run_all(*job);
  const auto series = job->series();
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[2].statistic, "count_within_0.1");
  EXPECT_EQ(series[2].degree, "1..10");
  EXPECT_EQ(series[2].values, std::vector<double>(3, 30));
}

}  // namespace
}  // namespace bezierbench::studies
