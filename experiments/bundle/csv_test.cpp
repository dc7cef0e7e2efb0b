// SPDX-License-Identifier: MIT
#include "experiments/bundle/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

std::string refusal(std::string_view text) {
  try {
    (void)parse_csv(text, "f.csv");
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::input_output);
    EXPECT_EQ(std::string(failure.what()).find('\n'), std::string::npos);
    return failure.what();
  }
  return "accepted";
}

TEST(Csv, QuotesOnlyWhereNeeded) {
  CsvTable table({"study", "note, free"});
  table.add_row({"2.1", "plain text; 'single'"});
  table.add_row({"a\"b", "two\nlines"});
  table.add_row({"", ""});
  EXPECT_EQ(table.text(),
            "study,\"note, free\"\n"
            "2.1,plain text; 'single'\n"
            "\"a\"\"b\",\"two\nlines\"\n"
            ",\n");
}

TEST(Csv, ReadsBackWhatItWrote) {
  const std::vector<std::vector<std::string>> rows{
      {"", "a,b"}, {"\"", "\"\""}, {"x\r\ny", "\n"}, {" blank ", "\r"}, {"é", "end"}};
  CsvTable table({"one", "two"});
  for (const auto& row : rows) table.add_row(row);
  const CsvDocument document = parse_csv(table.text(), "f.csv");
  EXPECT_THAT(document.header(), ElementsAre("one", "two"));
  ASSERT_EQ(document.row_count(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(document.row(i), rows[i]);
}

TEST(Csv, LoneEmptyFieldIsNotABlankLine) {
  CsvTable table({"x"});
  table.add_row({""});
  EXPECT_EQ(table.text(), "x\n\"\"\n");
  EXPECT_EQ(parse_csv(table.text(), "f.csv").at(0, "x"), "");
}

TEST(Csv, WriterRefusesWhatCannotBeATable) {
  EXPECT_THROW(CsvTable({}), std::invalid_argument);
  EXPECT_THROW(CsvTable({"a", "a"}), std::invalid_argument);
  EXPECT_THROW(CsvTable({"a", ""}), std::invalid_argument);
  CsvTable table({"a", "b"});
  EXPECT_THROW(table.add_row({"1"}), std::invalid_argument);
  EXPECT_THROW(table.add_row({"1", "2", "3"}), std::invalid_argument);
  EXPECT_THROW(table.add_row({"1", std::string(1, '\0')}), std::invalid_argument);
  EXPECT_EQ(table.text(), "a,b\n");
}

TEST(Csv, AcceptsByteOrderMarkCrlfAndNoFinalLineEnd) {
  const CsvDocument document = parse_csv("\xEF\xBB\xBF\"x\",y\r\n1,2\r\n3,", "f.csv");
  EXPECT_THAT(document.header(), ElementsAre("x", "y"));
  ASSERT_EQ(document.row_count(), 2U);
  EXPECT_EQ(document.at(0, "y"), "2");
  EXPECT_EQ(document.at(1, "x"), "3");
  EXPECT_EQ(document.at(1, "y"), "");
  EXPECT_EQ(parse_csv("x,y\n", "f.csv").row_count(), 0U);
}

TEST(Csv, KnowsColumnsAndLines) {
  const CsvDocument document = parse_csv("x,y\n\"a\nb\",1\n2,3\n", "f.csv");
  EXPECT_EQ(document.line(0), 2U);
  EXPECT_EQ(document.line(1), 4U);
  EXPECT_TRUE(document.has_column("y"));
  EXPECT_FALSE(document.has_column("z"));
  EXPECT_EQ(document.column("y"), 1U);
  EXPECT_THROW((void)document.at(2, "x"), std::out_of_range);
  try {
    (void)document.at(0, "z");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_THAT(failure.what(), StartsWith("f.csv:1: no column 'z'; "));
  }
}

TEST(Csv, RefusalsNameFileAndLine) {
  EXPECT_THAT(refusal(""), StartsWith("f.csv:1: file is empty; "));
  EXPECT_THAT(refusal("\xEF\xBB\xBF"), StartsWith("f.csv:1: file is empty; "));
  EXPECT_THAT(refusal("\nx\n"), StartsWith("f.csv:1: blank line"));
  EXPECT_THAT(refusal("x,y\n1,2,3\n"), StartsWith("f.csv:2: row has 3 fields, the header has 2; "));
  EXPECT_THAT(refusal("x,y\r\n1,2\r\n3"), StartsWith("f.csv:3: row has 1 field, the header has 2; "));
  EXPECT_THAT(refusal("x,y\n\"\n\",2\n3\n"), StartsWith("f.csv:4: row has 1 field"));
  EXPECT_THAT(refusal("x,y,x\n"), StartsWith("f.csv:1: column 'x' occurs twice"));
  EXPECT_THAT(refusal("x,\n"), StartsWith("f.csv:1: a column has no name"));
  EXPECT_THAT(refusal("x,y\n1,2\n\"3,4\n5,6\n"), StartsWith("f.csv:3: quote is never closed"));
  EXPECT_THAT(refusal("x\n1\n\n"), StartsWith("f.csv:3: blank line"));
  EXPECT_THAT(refusal("x\n1\"2\n"), StartsWith("f.csv:2: quote inside a field"));
  EXPECT_THAT(refusal("x\n\"1\"2\n"), StartsWith("f.csv:2: text after a closing quote"));
  EXPECT_THAT(refusal("x\n1\r2\n"), StartsWith("f.csv:2: carriage return"));
  EXPECT_THAT(refusal(std::string_view("x\n1\n\0\n", 6)), StartsWith("f.csv:3: character \\x00"));
  EXPECT_THAT(refusal("x\n\x1b]0;title\a\n"), StartsWith("f.csv:2: character \\x1b"));
}

}  // namespace
}  // namespace bezierbench::bundle
