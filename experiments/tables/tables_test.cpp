// SPDX-License-Identifier: MIT
#include "experiments/tables/tables.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bezierbench::tables {
namespace {

TEST(Tables, WriteColumnsInTheOrderOfTheSchemaWhateverTheOrderInWhichTheyAreSet) {
  Tables tables;
  tables.add(Row("digests.csv").set("rows", 3).set("study", "s").set("table", "t").set_each({"digest"}, {"d"}));
  EXPECT_EQ(tables.all().at("digests.csv").text(), "table,study,method,rows,digest\nt,s,,3,d\n");
}

TEST(Tables, NumbersAreTheShortestDecimalsAndNoneIsEmpty) {
  const auto fields =
      Row("spacing.csv").set("t", 0.1).set("gap", std::optional<double>()).set("x", std::optional(1e300)).fields();
  EXPECT_EQ(fields.at(8), "0.1");
  EXPECT_EQ(fields.at(9), "1e+300");
  EXPECT_EQ(fields.back(), "");
}

TEST(Tables, WhatTheSchemaDoesNotDeclareIsNotWritten) {
  Tables tables;
  EXPECT_THROW((void)tables.table("other.csv"), std::logic_error);
  EXPECT_THROW(Row("other.csv"), std::logic_error);
  EXPECT_THROW(Row("accuracy.csv").set("mean", 1), std::logic_error);
  EXPECT_THROW(Row("timing.csv").set("sittings", 1), std::logic_error) << "deprecated";
  EXPECT_THROW(Row("accuracy.csv").set("trials", 1).set("trials", 2), std::logic_error);
}

}  // namespace
}  // namespace bezierbench::tables
