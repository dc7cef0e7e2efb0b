// SPDX-License-Identifier: MIT
#include "experiments/suite/text/writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/vocabulary_test.hpp"

namespace bezierbench::suite {
namespace {

/// Whether the studies are of one kind and all its keys have equal text.
bool equal(const Study& a, const Study& b) {
  if (a.kind != b.kind) return false;
  return std::ranges::all_of(fields_of(kind_of(a)),
                             [&](const Field* field) { return to_text(*field, a) == to_text(*field, b); });
}

void expect_equal(const std::vector<Suite>& a, const std::vector<Suite>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].title, b[i].title);
    EXPECT_EQ(a[i].seed, b[i].seed);
    ASSERT_EQ(a[i].studies.size(), b[i].studies.size());
    for (std::size_t j = 0; j < a[i].studies.size(); ++j) {
      EXPECT_TRUE(equal(a[i].studies[j], b[i].studies[j])) << a[i].studies[j].id;
    }
  }
}

std::vector<Suite> read_back(const std::vector<Suite>& suites) {
  return parse_suites(to_toml(suites), "resolved", test_vocabulary());
}

TEST(Writer, ReportSuiteReadsBack) {
  const std::vector<Suite> suites{
      read_suite(BEZIERBENCH_SOURCE_DIR "/experiments/suites/report.toml", test_vocabulary())};
  expect_equal(suites, read_back(suites));
}

TEST(Writer, AwkwardTextsAndNumbersReadBack) {
  Study study;
  study.id = "a";
  study.title = "quote \" backslash \\ tab \t new\nline \x7f \u00e9 [x] # no = comment";
  study.kind = &studies::accuracy_kind.asks;
  study.degree = {2, 1023};
  study.coordinate_range = {0, 5e-324, 0x1p63, 0x1p70, 0x1p1020};
  study.t_interval = {{-0.1, 0x1p53}};
  study.trials = 1'000'000'007;
  const std::vector<Suite> suites{{"s", "T", (std::uint64_t{1} << 63U) - 1, {study}}};
  const auto back = read_back(suites);
  expect_equal(suites, back);
  EXPECT_EQ(back[0].studies[0].title, study.title);
}

TEST(Writer, OneSuiteIsWrittenAsPeopleWriteIt) {
  Study study;
  study.id = "a";
  study.kind = &studies::accuracy_kind.asks;
  study.degree = {4};
  study.coordinate_range = {1e6};
  const std::vector<Suite> suites{{"s", "T", 1, {study}}};
  EXPECT_EQ(to_toml(suites),
            "schema_version = 1\n\n[suite]\nid = \"s\"\ntitle = \"T\"\nseed = 1\n\n[[study]]\nid = \"a\"\n"
            "kind = \"accuracy\"\ncurve = \"bezier\"\ndimension = [2]\ndegree = [4]\n"
            "coordinate_range = [1e+06]\nt_interval = [[0, 1]]\ngenerator = [\"continuous\"]\nscalar = [\"double\"]\n"
            "trials = 1000\nreplicates = 1\nbaseline = [\"exact\"]\n");
}

}  // namespace
}  // namespace bezierbench::suite
