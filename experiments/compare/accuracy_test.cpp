// SPDX-License-Identifier: MIT
#include "experiments/compare/accuracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/compare/changes.hpp"
#include "experiments/compare/side_test.hpp"

namespace bezierbench::compare {
namespace {

constexpr const char* accuracy =
    "study,method,degree,trials,status,mean_error,max_error\n"
    "s,horner,3,10,ok,1e-17,3e-17\n"
    "s,direct,3,10,ok,1e-17,4e-17\n";
constexpr const char* worst =
    "worst_id,study,method,degree,trial,t,coefficients\n"
    "w1,s,horner,3,7,0x1p-1,0x1p+0\n"
    "w2,s,direct,3,8,0x1p-2,0x1p+3 0x1p+4\n";

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

TEST(Accuracy, TheSameIsIdentical) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}, {"worst.csv", worst}});
  const auto comparison = compare_accuracy(a, a);
  EXPECT_EQ(comparison.rows.size(), 4U);
  EXPECT_EQ(comparison.differing, 0U);
  EXPECT_TRUE(method_changes(comparison).empty());
  EXPECT_EQ(comparison.rows.front().column, "max_error");
  EXPECT_EQ(comparison.rows.front().a, "3e-17");
}

TEST(Accuracy, OneBitIsFoundWithBothValuesAndItsWorstInput) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}, {"worst.csv", worst}});
  const auto b =
      side_of("b", {{"accuracy.csv", replaced(accuracy, "4e-17", "4.000000000000001e-17")}, {"worst.csv", worst}});
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.differing, 1U);
  const auto* first = method_changes(comparison).front().differing.front();
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->inputs.field("method"), "direct");
  EXPECT_EQ(first->column, "max_error");
  EXPECT_EQ(first->a, "4e-17");
  EXPECT_EQ(first->b, "4.000000000000001e-17");
  EXPECT_EQ(first->line_a, 3U);
  const auto recorded = recorded_input(b, first->inputs);
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->id, "w2");
  EXPECT_EQ(recorded->trial, "8");
  EXPECT_EQ(recorded->coefficients, "0x1p+3 0x1p+4");
}

TEST(Accuracy, RowsOfOneSideAreCountedNotJudged) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}});
  const auto b = side_of("b", {{"accuracy.csv", std::string(accuracy) + "s,estrin,3,10,ok,0,0\n"},
                               {"conversion.csv", "study,conversion\nc,exact\n"}});
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.differing, 0U);
  EXPECT_EQ(comparison.only_a, 0U);
  EXPECT_EQ(comparison.only_b, 2U);
  EXPECT_FALSE(recorded_input(a, comparison.rows.front().inputs));
}

TEST(Accuracy, OtherTrialsOrAnotherSeedAreOtherInputs) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}});
  const auto more = side_of("b", {{"accuracy.csv", replaced(accuracy, "3,10,ok", "3,20,ok")}});
  EXPECT_EQ(compare_accuracy(a, more).rows.size(), 1U);
  auto seeded = a;
  seeded.manifest.seed = 2;
  EXPECT_TRUE(compare_accuracy(a, seeded).rows.empty());
  EXPECT_EQ(compare_accuracy(a, seeded).only_b, 2U);
}

TEST(Accuracy, SaysOfWhichMethodsItHolds) {
  const auto a = side_of("a", {{"accuracy.csv", std::string(accuracy) + "s,gone,3,10,ok,0,0\nt,direct,3,10,ok,0,0\n"}});
  const auto b = side_of("b", {{"accuracy.csv", replaced(std::string(accuracy), "4e-17", "5e-17") +
                                                    "s,new,3,10,ok,0,0\nt,direct,3,20,ok,0,0\n"}});
  const auto methods = compare_accuracy(a, b).methods;
  using Rows = bundle::Rows;
  EXPECT_EQ(methods.agreeing.size(), 1U);
  EXPECT_THAT(methods.differing, testing::ElementsAre(Rows{"accuracy.csv", "s", "direct"}));
  EXPECT_THAT(methods.other_rows, testing::ElementsAre(Rows{"accuracy.csv", "t", "direct"}));
  EXPECT_THAT(methods.only_a, testing::ElementsAre(Rows{"accuracy.csv", "s", "gone"}));
  EXPECT_THAT(methods.only_b, testing::ElementsAre(Rows{"accuracy.csv", "s", "new"}));
}

/// A bundle of schema version 1 lacks columns of later versions.
TEST(Accuracy, AColumnThatOneSideLacksIsNotCompared) {
  const auto a = side_of("a", {{"accuracy.csv", "study,method,max_error\ns,direct,1\n"}});
  const auto b = side_of("b", {{"accuracy.csv", "study,method,max_error,unbounded_trials\ns,direct,1,0\n"}});
  EXPECT_EQ(compare_accuracy(a, b).methods.agreeing.size(), 1U);
}

// The worst of 20 trials is not the worst of 10, and worst.csv does not say how many trials there were.
TEST(Accuracy, OfDifferentSuitesRowsWithoutTrialsAreLeftOut) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}, {"worst.csv", worst}});
  auto b = a;
  b.manifest.suite_digest = "another";
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.rows.size(), 2U);
  EXPECT_THAT(comparison.left_out, testing::ElementsAre("worst.csv"));
  EXPECT_EQ(comparison.methods.agreeing.size(), 4U) << "in both tables, since the digests are the same";
}

}  // namespace
}  // namespace bezierbench::compare
