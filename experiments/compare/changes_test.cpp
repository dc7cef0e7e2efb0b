// SPDX-License-Identifier: MIT
#include "experiments/compare/changes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "experiments/compare/side_test.hpp"

namespace bezierbench::compare {
namespace {

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
  EXPECT_EQ(growth(*changes[1].differing[0]), 4);
}

TEST(Changes, ShowTheLargestErrorIfItDiffers) {
  const auto both = compared("s,x,3,9,ok,1,2\n", "s,x,3,9,ok,5,3\n");
  EXPECT_EQ(shown_change(both.rows.front()).column, "max_error_u");
  EXPECT_EQ(shown_change(both.rows.front()).b, "3");
  const auto mean = compared("s,x,3,9,ok,1,2\n", "s,x,3,9,ok,5,2\n");
  EXPECT_EQ(shown_change(mean.rows.front()).column, "mean_error");
  EXPECT_EQ(growth(mean.rows.front()), 5);
}

TEST(Changes, ThatAreNoNumbersAreTheWorst) {
  EXPECT_EQ(growth(compared("s,x,3,9,ok,1,2\n", "s,x,3,9,ok,1,nan\n").rows.front()),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(growth(compared("s,x,3,9,ok,1,0\n", "s,x,3,9,ok,1,2\n").rows.front()),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace bezierbench::compare
