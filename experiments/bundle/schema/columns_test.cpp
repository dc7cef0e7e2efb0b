// SPDX-License-Identifier: MIT
#include "experiments/bundle/schema/columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace bezierbench::bundle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

TEST(Columns, AreThoseOfTheSchemaInItsOrder) {
  const auto* table = declared_table("conversion.csv");
  ASSERT_NE(table, nullptr);
  EXPECT_THAT(table->header(), ElementsAre("study", "conversion", "degree", "coordinate_range", "generator", "trials",
                                           "mean_error", "max_error", "within_1e-5", "within_1e-3", "within_0.1",
                                           "form", "dimension", "status", "non_finite", "curves"));
  EXPECT_EQ(table->method, "conversion");
  EXPECT_TRUE(table->is_deterministic);
  EXPECT_EQ(declared_table("other.csv"), nullptr);
  EXPECT_EQ(table->column("method"), nullptr);
}

TEST(Columns, OfATableThatIsAsAnotherOne) {
  const auto* unstable = declared_table("unstable.csv");
  EXPECT_EQ(unstable->header(), declared_table("accuracy.csv")->header());
  EXPECT_FALSE(unstable->is_deterministic);
  EXPECT_TRUE(unstable->digested().empty());
}

TEST(Columns, SayWhetherTheyHoldNumbersAndWhatARowIsAbout) {
  const auto& timing = *declared_table("timing.csv");
  for (const char* name : {"dimension", "degree", "tolerance", "points"}) {
    EXPECT_TRUE(timing.column(name)->is_number) << name;
    EXPECT_TRUE(timing.column(name)->is_key) << name;
  }
  for (const char* name : {"study", "method", "data", "mode"}) EXPECT_FALSE(timing.column(name)->is_number) << name;
  EXPECT_TRUE(timing.column("median_ns")->is_number);
  EXPECT_FALSE(timing.column("median_ns")->is_key);
  EXPECT_FALSE(declared_table("scorecard.csv")->column("degree")->is_number) << "1..20 is a range";
  EXPECT_TRUE(declared_table("accuracy.csv")->column("max_error")->is_number) << "also where it is inf";
  EXPECT_FALSE(declared_table("worst.csv")->column("t")->is_number);
}

/// Digests are taken per study and method, so that every row must name both.
TEST(Columns, OfDeterministicTablesNameStudyAndMethod) {
  for (const auto& table : declared_tables()) {
    if (!table.is_deterministic) continue;
    ASSERT_NE(table.column(table.study), nullptr) << table.file;
    ASSERT_NE(table.column(table.method), nullptr) << table.file;
    EXPECT_TRUE(table.column(table.study)->is_key) << table.file;
    EXPECT_TRUE(table.column(table.method)->is_key) << table.file;
  }
}

/// Keys of the same name identify the same thing in different tables.
TEST(Columns, KeysOfOneNameAreOfOneType) {
  std::map<std::string, bool> seen;
  for (const auto& table : declared_tables())
    for (const auto& column : table.columns)
      if (column.is_key && !(column.name == "degree" && table.study == "table")) {
        EXPECT_EQ(seen.try_emplace(column.name, column.is_number).first->second, column.is_number)
            << table.file << ' ' << column.name;
      }
}

}  // namespace
}  // namespace bezierbench::bundle
