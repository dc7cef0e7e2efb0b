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

std::vector<std::string> faults(const std::string& rows) {
  const auto listed = parse_csv(methods, "methods.csv");
  const auto judged = parse_csv("method,degree,property,broken,verdict\n" + rows, "guarantees.csv");
  ProvedProperties properties;
  properties.read("guarantees.csv", judged);  // in any order
  properties.read("methods.csv", listed);
  return properties.faults();
}

TEST(ProvedProperties, AreRefutedByARow) {
  EXPECT_THAT(faults("b,1,ends_exact,1,refuted\na,1,ends_exact,1,refuted\n"),
              ElementsAre("guarantees.csv:3: ends_exact of a is refuted, and proved according to methods.csv"));
}

TEST(ProvedProperties, HoldUpToADegree) {
  EXPECT_THAT(faults("a,3,monotone,1,refuted\n"), IsEmpty());
  EXPECT_EQ(faults("a,2,monotone,1,refuted\n").size(), 1U);
}

TEST(ProvedProperties, AreNotRefutedByOtherVerdicts) {
  EXPECT_THAT(faults("a,1,ends_exact,0,proved\na,1,in_hull,1,refuted\nb,1,in_hull,0,not_refuted\n"), IsEmpty());
}

TEST(ProvedProperties, AreThoseOfTheList) {
  EXPECT_THAT(faults("b,1,ends_exact,0,proved\na,3,monotone,0,proved\na,1,ends_exact,0,not_refuted\n"),
              ElementsAre("guarantees.csv:2: ends_exact of b is proved, and not proved according to methods.csv",
                          "guarantees.csv:3: monotone of a is proved, and not proved according to methods.csv",
                          "guarantees.csv:4: ends_exact of a is not refuted, and proved according to methods.csv"));
}

TEST(ProvedProperties, AreRefutedByWhatBreaksThem) {
  EXPECT_THAT(faults("c,1,in_hull,2,not_refuted\n"),
              ElementsAre("guarantees.csv:2: 2 inputs break in_hull of c, which is not refuted"));
}

TEST(ProvedProperties, AreNoneWithoutTheColumns) {
  ProvedProperties properties;
  properties.read("methods.csv", parse_csv("id,form\na,bernstein\n", "methods.csv"));
  properties.read("guarantees.csv", parse_csv("method,degree\na,1\n", "guarantees.csv"));
  EXPECT_THAT(properties.faults(), IsEmpty());
}

}  // namespace
}  // namespace bezierbench::bundle
