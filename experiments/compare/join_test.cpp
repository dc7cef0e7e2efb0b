// SPDX-License-Identifier: MIT
#include "experiments/compare/join.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bezierbench::compare {
namespace {

using testing::ElementsAre;

bundle::CsvDocument table(std::string_view text) { return bundle::parse_csv(text, "table.csv"); }

/// The table that has most of the keys.
const bundle::DeclaredTable& timing() { return *bundle::declared_table("timing.csv"); }

std::vector<std::pair<std::size_t, std::size_t>> pairs(const Join& joined) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const auto& pair : joined.pairs) found.emplace_back(pair.a, pair.b);
  return found;
}

TEST(Join, FindsRowsByTheirInputsInAnyOrderOfRowsAndColumns) {
  const auto a = table("study,degree,error\ns,3,1\ns,4,2\nt,3,3\n");
  const auto b = table("error,degree,study\n9,3,t\n9,5,s\n9,3,s\n");
  const auto joined = join(timing(), a, b);
  EXPECT_THAT(pairs(joined), ElementsAre(std::pair(0, 2), std::pair(2, 0)));
  EXPECT_EQ(joined.only_a.size(), 1U);
  EXPECT_EQ(joined.only_b.size(), 1U);
}

TEST(Join, OrdersAndTolerancesTellRowsApart) {
  const auto joined = join(timing(), table("study,order,tolerance\ns,1,1e-3\ns,2,1e-3\n"),
                           table("study,order,tolerance\ns,2,1e-3\ns,1,1e-6\n"));
  EXPECT_THAT(pairs(joined), ElementsAre(std::pair(1, 0)));
}

TEST(Join, NumbersAgreeAsValuesAndNamesAsText) {
  const auto joined =
      join(timing(), table("study,coordinate_range\n2.2,1e+06\n"), table("study,coordinate_range\n2.2,1000000\n"));
  EXPECT_EQ(joined.pairs.size(), 1U);
  EXPECT_EQ(join(timing(), table("study,degree\n2.2,1\n"), table("study,degree\n2.20,1\n")).pairs.size(), 0U);
}

// A table of an older program may lack a column. The columns that are left decide, and repeated rows are paired in
// order.
TEST(Join, AColumnThatOneSideLacksDoesNotPartThem) {
  const auto a = table("study,scalar,degree,error\ns,double,3,1\ns,float,3,2\n");
  const auto joined = join(timing(), a, table("study,degree,error\ns,3,1\ns,3,2\n"));
  EXPECT_THAT(pairs(joined), ElementsAre(std::pair(0, 0), std::pair(1, 1)));
}

TEST(Join, ConversionsAreTheMethodsOfTheirTable) {
  const auto a = table("study,conversion\nc,exact\nc,factorial\n");
  const auto joined = join(*bundle::declared_table("conversion.csv"), a, table("study,conversion\nc,factorial\n"));
  ASSERT_EQ(joined.pairs.size(), 1U);
  EXPECT_EQ(joined.pairs.front().inputs.field("method"), "factorial");
}

TEST(Join, InputsInWords) {
  const auto a = table("degree,method,study,error\n4,horner,s,1\n");
  const Inputs inputs(timing(), a, 0, a);
  EXPECT_EQ(inputs.words(), "study s, method horner, degree 4");
  EXPECT_EQ(inputs.without_method().words(), "study s, degree 4");
  EXPECT_EQ(inputs.field("statistic"), "") << "a key of another table";
}

TEST(SameValue, IsTheSameDoubleToTheLastBitOrTheSameText) {
  EXPECT_TRUE(same_value("0.1", "0.10"));
  EXPECT_TRUE(same_value("0x1p-1", "5e-1"));
  EXPECT_FALSE(same_value("0.1", "0.10000000000000002"));
  EXPECT_FALSE(same_value("0", "-0"));
  EXPECT_TRUE(same_value("nan", "nan"));
  EXPECT_FALSE(same_value("", "0"));
  EXPECT_TRUE(same_value("ok", "ok"));
  EXPECT_FALSE(same_value("0x1p+0 0x1p+1", "0x1p+0 0x1p+2"));
}

}  // namespace
}  // namespace bezierbench::compare
