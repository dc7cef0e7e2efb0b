// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "experiments/judge/input_fields.hpp"
#include "experiments/studies/guarantees/search_for_counterexample.hpp"
#include "experiments/studies/study_test.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_guarantees_study() {
  auto study = small_study("guarantees");
  study.budget = 2000;
  study.scalar = {suite::ScalarKind::float64, suite::ScalarKind::float32};
  study.degree = {1, 3};
  study.methods = {"de_casteljau*", "horner_bernstein", "correctly_rounded", "direct_pow"};
  study.trials = 70000;  // two blocks, the last one short
  return study;
}

TEST(GuaranteesStudy, OrderAndInterruptionsChangeNoByte) {
  auto study = small_guarantees_study();
  study.methods = {"de_casteljau_two_sided"};
  study.degree = {2};
  study.properties = {"in_hull", "monotone"};
  run::expect_order_changes_nothing(make_job, study);
}

/// Verdicts that follow from the formulas alone, at degrees 1 and 3.
TEST(GuaranteesStudy, DecidesWhatIsKnown) {
  auto study = small_guarantees_study();
  study.trials = 300;
  study.budget = 20000;
  const auto table = rows_of(study, "guarantees.csv");
  std::map<std::string, int> verdicts;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    ++verdicts[std::string(table.at(row, "verdict"))];
    const std::string method(table.at(row, "method"));
    const std::string property(table.at(row, "property"));
    EXPECT_NE(method, "direct_pow");
    const bool refuted = table.at(row, "verdict") == "refuted";
    EXPECT_EQ(refuted, number::parse_number(table.at(row, "largest")).value_or(0) > 0) << method << ' ' << property;
    const bool never_kept = property == "in_convex_hull" || property == "translation";
    EXPECT_TRUE(refuted || !never_kept) << method;
    if (method == "correctly_rounded") {
      EXPECT_EQ(refuted, never_kept || property == "total") << property;
    }
    if (property == "ends_exact") {
      EXPECT_EQ(refuted, method.starts_with("de_casteljau_lerp")) << method;
    }
    // The fused form loses constants where it underflows.
    if (property == "constant_reproduced" && method.starts_with("de_casteljau_")) {
      EXPECT_EQ(refuted, method == "de_casteljau_fma") << method;
    }
    EXPECT_EQ(table.at(row, "t_next").empty(), property != "monotone" || table.at(row, "t").empty());
    EXPECT_EQ(table.at(row, "offset").empty(), property != "translation");
  }
  EXPECT_GT(verdicts["proved"], 50);
  EXPECT_GT(verdicts["refuted"], 50);
}

TEST(GuaranteesStudy, CounterexamplesAreReplayed) {
  auto study = small_guarantees_study();
  study.scalar = {suite::ScalarKind::float64};
  study.trials = 300;
  const auto table = rows_of(study, "guarantees.csv");
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    if (table.at(row, "verdict") != "refuted") continue;
    sample::Cell cell;
    cell.degree = table.at(row, "degree") == "1" ? 1 : 3;
    const auto read = judge::parse_input({table.at(row, "t"), table.at(row, "coefficients"), ""}, cell);
    ASSERT_TRUE(read);
    const guarantees::Case<double> input{2, read->coefficients, read->t,
                                         number::parse_number(table.at(row, "t_next")).value_or(0),
                                         number::parse_number(table.at(row, "offset")).value_or(0)};
    for (const auto& statement : guarantees::statements<double>) {
      if (name(statement.property) != table.at(row, "property")) continue;
      guarantees::Evaluation<double> method(*find_kernel<double>(table.at(row, "method"), Form::bernstein, 2));
      EXPECT_GT(statement.excess(method, input).value_or(-1), 0) << table.at(row, "method");
    }
  }
}

TEST(GuaranteesStudy, UnstableMethodsAreInNoDigest) {
  auto study = small_guarantees_study();
  study.methods = {"direct_pow"};
  study.trials = 10;
  EXPECT_GT(rows_of(study, "guarantees_unstable.csv").row_count(), 10U);
}

}  // namespace
}  // namespace bezierbench::studies
