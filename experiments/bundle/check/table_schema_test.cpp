// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/table_schema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bezierbench::bundle {
namespace {

/// What is wrong with a field of a column; empty where nothing is.
std::string fault(const std::string& file, const std::string& column, const std::string& field) {
  for (const auto& line : table_faults(file, parse_csv(column + ",x\n" + field + ",\n", file)))
    if (line.starts_with(file + ":2: ")) return line.substr(file.size() + 4);
  return {};
}

/// Each keyword by a column that has it, with fields that it admits and one that it does not.
TEST(TableSchema, Keywords) {
  struct Case {
    const char* file;
    const char* column;
    std::vector<const char*> good;
    const char* bad;
    const char* keyword;
  };
  for (const auto& [file, column, good, bad, keyword] :
       {Case{"accuracy.csv", "degree", {"0", "12"}, "3.5", "type \"integer\""},
        Case{"accuracy.csv", "degree", {"3"}, "", "type \"integer\""},
        Case{"accuracy.csv", "degree", {"3"}, "03", "type \"integer\""},
        Case{"accuracy.csv", "t_min", {"-0.25", "1e-300", "1e+22"}, "1e", "type \"number\""},
        Case{"accuracy.csv", "t_min", {"0.1"}, "0.10", "type \"number\""},
        Case{"accuracy.csv", "t_min", {"0.1"}, "inf", "type \"number\""},
        Case{"accuracy.csv", "non_finite", {"", "0"}, "1.5", "type [\"integer\",\"null\"]"},
        Case{"accuracy.csv", "scalar", {"float", "double"}, "half", "enum [\"float\",\"double\"]"},
        Case{"timing.csv", "checked", {"yes", "no"}, "", "enum [\"yes\",\"no\"]"},
        Case{"audit.csv", "tier", {"long_double"}, "exact", "const \"long_double\""},
        Case{"accuracy.csv", "dimension", {"1", "3"}, "0", "minimum 1"},
        Case{"accuracy.csv", "dimension", {"1", "3"}, "4", "maximum 3"},
        Case{"arc_length.csv", "tolerance", {"0.001"}, "0", "exclusiveMinimum 0"},
        Case{"accuracy.csv", "study", {"a", "12"}, "", "minLength 1"},
        Case{"worst.csv", "worst_id", {"w1", "w20"}, "w0", "pattern \"^w[1-9][0-9]*$\""},
        Case{"accuracy.csv", "mean_error", {"", "0.5", "inf"}, "-1", "minimum 0"},
        Case{"scorecard.csv", "degree", {"3", "2..9"}, "2-9", "type \"integer\""}}) {
    for (const auto* field : good) EXPECT_EQ(fault(file, column, field), "") << column << ' ' << field;
    EXPECT_EQ(fault(file, column, bad), std::string(column) + " is \"" + bad + "\"; its schema requires " + keyword);
  }
}

}  // namespace
}  // namespace bezierbench::bundle
