// SPDX-License-Identifier: MIT
#include "experiments/compare/accuracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

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
  EXPECT_EQ(comparison.differing(), 0U);
  EXPECT_TRUE(method_changes(comparison).empty());
  EXPECT_EQ(comparison.rows.front().first.column, "max_error");
  EXPECT_EQ(comparison.rows.front().first.a, "3e-17");
}

TEST(Accuracy, OneBitIsFoundWithBothValuesAndItsWorstInput) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}, {"worst.csv", worst}});
  const auto b =
      side_of("b", {{"accuracy.csv", replaced(accuracy, "4e-17", "4.000000000000001e-17")}, {"worst.csv", worst}});
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.differing(), 1U);
  const auto* first = method_changes(comparison).front().differing.front();
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->inputs.field("method"), "direct");
  EXPECT_EQ(first->first.column, "max_error");
  EXPECT_EQ(first->first.a, "4e-17");
  EXPECT_EQ(first->first.b, "4.000000000000001e-17");
  EXPECT_EQ(first->line_a, 3U);
  EXPECT_EQ(recorded_input(b, first->inputs), "w2");
}

TEST(Accuracy, RowsOfOneSideAreCountedNotJudged) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}});
  const auto b = side_of("b", {{"accuracy.csv", std::string(accuracy) + "s,estrin,3,10,ok,0,0\n"},
                               {"conversion.csv", "study,conversion\nc,exact\n"}});
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.differing(), 0U);
  EXPECT_EQ(comparison.only_a, 0U);
  EXPECT_EQ(comparison.only_b, 2U);
  EXPECT_EQ(comparison.methods.at({"conversion.csv", "c", "exact"}).only_b, 1U) << "of a table that a lacks";
  EXPECT_EQ(recorded_input(a, comparison.rows.front().inputs), "");
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
  const auto counts = [&](const std::string& study, const std::string& method) {
    const auto& of = methods.at({"accuracy.csv", study, method});
    return std::array{of.pairs, of.differing, of.only_a, of.only_b};
  };
  EXPECT_EQ(methods.size(), 5U);
  EXPECT_THAT(counts("s", "horner"), testing::ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(counts("s", "direct"), testing::ElementsAre(1, 1, 0, 0));
  EXPECT_THAT(counts("t", "direct"), testing::ElementsAre(0, 0, 1, 1)) << "other trials";
  EXPECT_THAT(counts("s", "gone"), testing::ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(counts("s", "new"), testing::ElementsAre(0, 0, 0, 1));
}

TEST(Accuracy, AColumnThatOneSideLacksIsNotCompared) {
  const auto a = side_of("a", {{"accuracy.csv", "study,method,max_error\ns,direct,1\n"}});
  const auto b = side_of("b", {{"accuracy.csv", "study,method,max_error,unbounded_trials\ns,direct,1,0\n"}});
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.rows.size(), 1U);
  EXPECT_EQ(comparison.differing(), 0U);
}

// The worst of 20 trials is not the worst of 10, and worst.csv does not say how many trials there were.
TEST(Accuracy, OfDifferentSuitesRowsWithoutTrialsAreLeftOut) {
  const auto a = side_of("a", {{"accuracy.csv", accuracy}, {"worst.csv", worst}});
  auto b = a;
  b.manifest.suite_digest = "another";
  const auto comparison = compare_accuracy(a, b);
  EXPECT_EQ(comparison.rows.size(), 2U);
  EXPECT_THAT(comparison.left_out, testing::ElementsAre("worst.csv"));
  EXPECT_EQ(comparison.methods.size(), 4U) << "equal rows agree in both tables";
  EXPECT_EQ(comparison.methods.at({"worst.csv", "s", "direct"}).pairs, 1U);
}

/// Rows of methods in two cells: mean and largest error of the first, then of the second.
AccuracyComparison compared(const std::string& a, const std::string& b) {
  const std::string header = "study,method,degree,trials,status,mean_error,max_error_u\n";
  return compare_accuracy(side_of("a", {{"accuracy.csv", header + a}}), side_of("b", {{"accuracy.csv", header + b}}));
}

TEST(Changes, AreByMethodAndTheWorstFirst) {
  const auto comparison = compared("s,x,3,9,ok,1,2\ns,x,4,9,ok,1,2\ns,y,3,9,ok,1,2\ns,z,3,9,ok,1,2\n",
                                   "s,x,3,9,ok,1,3\ns,x,4,9,ok,1,8\ns,y,3,9,ok,1,10\ns,z,3,9,ok,1,2\n");
  const auto changes = method_changes(comparison);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].method, "y");
  EXPECT_EQ(changes[1].method, "x");
  EXPECT_EQ(changes[1].rows, 2U);
  ASSERT_EQ(changes[1].differing.size(), 2U);
  EXPECT_EQ(changes[1].differing[0]->inputs.field("degree"), "4");
  EXPECT_EQ(changes[1].differing[0]->growth(), 4);
}

TEST(Changes, ShowTheLargestErrorIfItDiffers) {
  const auto both = compared("s,x,3,9,ok,1,2\n", "s,x,3,9,ok,5,3\n");
  EXPECT_EQ(both.rows.front().shown.column, "max_error_u");
  EXPECT_EQ(both.rows.front().shown.b, "3");
  const auto mean = compared("s,x,3,9,ok,1,2\n", "s,x,3,9,ok,5,2\n");
  EXPECT_EQ(mean.rows.front().shown.column, "mean_error");
  EXPECT_EQ(mean.rows.front().growth(), 5);
}

TEST(Changes, ThatAreNotNumbersAreTheWorst) {
  EXPECT_EQ(compared("s,x,3,9,ok,1,2\n", "s,x,3,9,ok,1,nan\n").rows.front().growth(),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(compared("s,x,3,9,ok,1,0\n", "s,x,3,9,ok,1,2\n").rows.front().growth(),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bezierbench::compare
