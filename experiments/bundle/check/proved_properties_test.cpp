// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/proved_properties.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bezierbench::bundle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const char* const methods =
    "id,form,guarantees\n"
    "a,bernstein,ends_exact monotone:2\n"
    "a,rational,\n"
    "b,bernstein,\n";

std::vector<std::string> refuted(const std::string& rows) {
  const auto listed = parse_csv(methods, "methods.csv");
  const auto judged = parse_csv("method,degree,property,verdict\n" + rows, "guarantees.csv");
  ProvedProperties properties;
  properties.read("guarantees.csv", judged);  // in any order
  properties.read("methods.csv", listed);
  return properties.refuted();
}

TEST(ProvedProperties, AreRefutedByARow) {
  EXPECT_THAT(refuted("b,1,ends_exact,refuted\na,1,ends_exact,refuted\n"),
              ElementsAre("guarantees.csv:3: ends_exact of a is refuted, and proved according to methods.csv"));
}

TEST(ProvedProperties, HoldUpToADegree) {
  EXPECT_THAT(refuted("a,3,monotone,refuted\n"), IsEmpty());
  EXPECT_EQ(refuted("a,2,monotone,refuted\n").size(), 1U);
}

TEST(ProvedProperties, AreNotRefutedByOtherVerdicts) {
  EXPECT_THAT(refuted("a,1,ends_exact,proved\na,1,in_hull,refuted\nb,1,in_hull,not_refuted\n"), IsEmpty());
}

TEST(ProvedProperties, AreNoneWithoutTheColumns) {
  ProvedProperties properties;
  properties.read("methods.csv", parse_csv("id,form\na,bernstein\n", "methods.csv"));
  properties.read("guarantees.csv", parse_csv("method,degree\na,1\n", "guarantees.csv"));
  EXPECT_THAT(properties.refuted(), IsEmpty());
}

}  // namespace
}  // namespace bezierbench::bundle
