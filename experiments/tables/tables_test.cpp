// SPDX-License-Identifier: MIT
#include "experiments/tables/tables.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "experiments/tables/table_row.hpp"

namespace bezierbench::tables {
namespace {

Row digests_row() {
  return Row("digests.csv").set("rows", 3).set("study", "s").set("table", "t").set_each<const char*>({"digest"}, {"d"});
}

TEST(Tables, WriteColumnsInTheOrderOfTheSchemaWhateverTheOrderInWhichTheyAreSet) {
  Tables tables;
  tables.add(digests_row());
  EXPECT_EQ(tables.all().at("digests.csv").text(), "table,study,method,rows,digest\nt,s,,3,d\n");
}

TEST(Tables, KeepNumbersUntilTheyAreWritten) {
  const auto row = Row("spacing.csv").set("t", 0.1).set("gap", std::optional<double>()).set("x", std::optional(1e300));
  EXPECT_EQ(row.field("t"), Field(0.1));
  EXPECT_EQ(row.field("gap"), Field());
  EXPECT_EQ(field(""), Field());
  EXPECT_EQ(field(3U), Field(std::int64_t{3}));
  EXPECT_EQ(row.texts().at(8), "0.1") << "the shortest decimal";
  EXPECT_EQ(row.texts().at(9), "1e+300");
  EXPECT_EQ(row.texts().back(), "");
  EXPECT_EQ(text(Hexadecimal{0.1}), "0x1.999999999999ap-4");
}

/// A row is read in the same way before it is written and after it was read back.
TEST(Tables, GiveTheSameRowsFromAFile) {
  Table table(*bundle::declared_table("search.csv"));
  table.add(Row("search.csv").set("method", "m").set("degree", 5).set("bound_u", 0.1).set("error", ""));
  const auto document = bundle::parse_csv(table.text(), "search.csv");
  for (const auto& row : {rows_of(table).front(), rows_of(document).front()}) {
    EXPECT_EQ(row.text("method"), "m");
    EXPECT_EQ(row.text("error"), "");
    EXPECT_EQ(text(row.field("degree")), "5");
    EXPECT_EQ(row.number("degree"), 5);
    EXPECT_EQ(row.optional_number("bound_u"), 0.1);
    EXPECT_EQ(row.optional_number("error"), std::nullopt);
  }
}

/// The digests that a run makes of its rows are those that verify makes of the file.
TEST(Tables, AreDigestedAsTheyAreWritten) {
  const auto& declared = *bundle::declared_table("search.csv");
  Table table(declared);
  for (const auto* method : {"a", "b", "a"}) table.add(Row("search.csv").set("study", "s").set("method", method));
  const auto [text, digests] = table.written();
  EXPECT_EQ(text, table.text());
  EXPECT_EQ(digests.size(), 2U);
  EXPECT_EQ(digests, bundle::method_digests(declared, bundle::parse_csv(text, "search.csv"), declared.digested()));
  Table times(*bundle::declared_table("timing.csv"));
  times.add(Row("timing.csv").set("study", "s"));
  EXPECT_TRUE(times.written().digests.empty());
}

TEST(Tables, WhatTheSchemaDoesNotDeclareIsNotWritten) {
  Tables tables;
  EXPECT_THROW((void)tables.table("other.csv"), std::logic_error);
  EXPECT_THROW(Row("other.csv"), std::logic_error);
  EXPECT_THROW(Row("accuracy.csv").set("mean", 1), std::logic_error);
  EXPECT_THROW(Row("accuracy.csv").set("trials", 1).set("trials", 2), std::logic_error);
}

}  // namespace
}  // namespace bezierbench::tables
