// SPDX-License-Identifier: MIT
#include "reference/curves/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <stdexcept>

namespace bezierbench::curves {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal_of(std::string_view text) {
  try {
    (void)read_csv(text, "c.csv", Form::bernstein);
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "read";
}

CurveSet random_set(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto number = [&] {
    for (;;) {
      const auto value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return random() % 8 == 0 ? -0.0 : value;
    }
  };
  CurveSet set;
  for (int k = 0; k < 50; ++k) {
    const Form form = std::array{Form::bernstein, Form::power, Form::rational}.at(random() % 3);
    const auto dimension = static_cast<int>(1 + random() % 3);
    const auto degree = static_cast<int>(random() % 7);
    std::vector<double> numbers(static_cast<std::size_t>(dimension * (degree + 1)));
    for (auto& x : numbers) x = number();
    std::vector<double> weights(form == Form::rational ? static_cast<std::size_t>(degree) + 1 : 0);
    for (auto& x : weights) x = std::abs(number()) + 1;
    std::vector<double> parameters(random() % 9);
    for (auto& t : parameters) t = number();
    set.add(k == 0 ? "" : "a \"," + std::to_string(random()), {form, dimension, degree, numbers, weights}, true,
            parameters);
  }
  return set;
}

TEST(Csv, WhatIsWrittenReadsBackToTheSameBits) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto set = random_set(seed);
    const auto again = read_csv(to_csv(set), "c.csv", Form::bernstein).set;
    EXPECT_EQ(again.canonical_bytes(), set.canonical_bytes());
    for (std::size_t k = 0; k < set.size(); ++k) EXPECT_EQ(again.id(k), set.id(k));
  }
}

TEST(Csv, AFileWithoutIdsIsOneCurve) {
  const auto set = read_csv("\xEF\xBB\xBFw,y,x\r\n1,2,0x1p3\r\n2,-0,.5\r\n", "c.csv", Form::bernstein).set;
  ASSERT_EQ(set.size(), 1);
  EXPECT_EQ(set.id(0), "");
  EXPECT_EQ(set[0].form, Form::rational);
  EXPECT_THAT(set[0].coefficients, ElementsAre(8, 2, 0.5, 0));
  EXPECT_THAT(set[0].weights, ElementsAre(1, 2));
}

TEST(Csv, ParametersAndPaths) {
  const auto set =
      read_csv("segment,index,x,t\n2,0,1,0.25\n2,1,2,\n2,2,,0.5\n3,0,2,\n3,1,4,\n4,0,5,\n4,1,6,\n6,0,6,\nz,0,6,\n", "c",
               Form::bernstein)
          .set;
  ASSERT_EQ(set.size(), 5);
  EXPECT_THAT(set.parameters(0), ElementsAre(0.25, 0.5));
  EXPECT_THAT(set[0].coefficients, ElementsAre(1, 2));
  std::vector<bool> begins;
  for (std::size_t k = 0; k < set.size(); ++k) begins.push_back(set.begins_path(k));
  EXPECT_THAT(begins, ElementsAre(true, false, true, true, true));  // 5 is not where segment 3 ends; 6 is not 4 + 1
}

TEST(Csv, ErrorsNameLineAndColumn) {
  for (const auto& [text, needle] :
       {std::pair("", "c.csv:1: file is empty"),
        {"x,y\n", "c.csv: no coefficients"},
        {"x\n1\n\n", "c.csv:3: blank line"},
        {"x\n1\n1,2\n", "c.csv:3: row has 2 fields, the header has 1"},
        {"x,x\n1,1\n", "occurs twice"},
        {"x,\n1,1\n", "no name"},
        {"x\n\"1\n", "c.csv:2: quote is never closed"},
        {"x\n1\"\n", "quote inside"},
        {"x\n\"1\"2\n", "after a closing quote"},
        {"x\r1\r", "carriage return"},
        {"x\n1\x1b\n", "c.csv:2: character \\x1b"},
        {"x\nnan\n", "c.csv:2: row 1, column x: \"nan\" is not a finite"},
        {"x\n1e999\n", "too large"},
        {"1 2\n", "header is missing"},
        {"x,q\n1,2\n", "header is \"x,q\""},
        {"curve,index,x\na,0,1\nb,0,2\na,0,3\n", "c.csv:4: curve \"a\" has rows above already"},
        {"curve,index,x\na,0,1\nb,0,2\na,1,3\n", "c.csv:4: curve \"a\" has rows above already"},
        {"curve,index,x\na,0,1\na,2,2\n", "c.csv:3: index is \"2\", here must be 1"},
        {"curve,index,x,y\na,0,1,\na,1,2,3\n", "c.csv:3: row 2, column y"},
        {"curve,index,x\na,0,\n", "column x: \"\""},
        {"curve,index,x,w\na,0,1,0\na,1,2,0\n", "c.csv:2: rows 1 to 2, column w: every weight is 0"},
        {"curve,index,form,x\na,0,cubic,1\n", "c.csv:2: form \"cubic\""},
        {"x,t\n1,0\n,1\n2,\n", "c.csv:4: a coefficient below"}})
    EXPECT_THAT(refusal_of(text), HasSubstr(needle)) << text;
  EXPECT_THAT(refusal_of("x\n" +
                         [] {
                           std::string rows;
                           for (int k = 0; k < 1025; ++k) rows += "1\n";
                           return rows;
                         }()),
              HasSubstr("1025 coefficients"));
  EXPECT_THROW((void)read_csv("x,w\n1,1\n", "c.csv", Form::power), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench::curves
