// SPDX-License-Identifier: MIT
#include "experiments/race/counts.hpp"

#include <gtest/gtest.h>

#include "experiments/failure.hpp"

namespace bezierbench::race {
namespace {

/// As Callgrind writes it, shortened.
std::string file_of(const std::string& trigger, const std::string& totals,
                    const std::string& events = "Ir Dr Dw I1mr Bc Bcm Bi Bim") {
  return "# callgrind format\nversion: 1\ndesc: I1 cache: 32768 B\ndesc: Trigger: " + trigger +
         "\npositions: line\nevents: " + events + "\nfn=(1) run\n0 " + totals + "\ntotals: " + totals + "\n";
}

TEST(Counts, ArePerPointByPartAndRival) {
  const std::vector<std::string> files{file_of("Client Request: 7 1 0 64 AVX2", "640 128 64 5 32 1 32 0"),
                                       file_of("Client Request: 7 0 1 10 ", "100 20 10 5 10 1 0 0"),
                                       file_of("Client Request: 7 0 0 10 ", "70 20 10 5 10 1 0 0"),
                                       file_of("Client Request: 6 0 0 10 ", "1 1 1 1 1 1 1 1"),
                                       file_of("Program termination", "9 9 9 9 9 9 9 9")};
  const auto all = read_counts(files, 7);
  ASSERT_EQ(all.size(), 2U);
  ASSERT_EQ(all[0].size(), 2U);
  EXPECT_EQ(all[0][0].instructions, 7);
  EXPECT_EQ(all[0][1].instructions, 10);
  EXPECT_EQ(all[0][1].target, "");
  EXPECT_EQ(all[1][0].instructions, 10);
  EXPECT_EQ(all[1][0].loads, 2);
  EXPECT_EQ(all[1][0].stores, 1);
  EXPECT_EQ(all[1][0].branches, 1);
  EXPECT_EQ(all[1][0].target, "AVX2");
}

TEST(Counts, OfAnotherFormatAreRefused) {
  EXPECT_THROW(read_counts(std::vector<std::string>{file_of("Client Request: 0 0 0 1 ", "640", "Ir")}, 0), Failure);
}

/// This test does not run under Valgrind, and its requests do nothing.
TEST(Counts, OutsideOfValgrindNothingIsCounted) {
  EXPECT_FALSE(runs_under_valgrind());
  std::size_t runs = 0;
  count(std::vector<Rival>{{"x", 1, [&] { ++runs; }, [] { return true; }}}, 0, 0);
  EXPECT_EQ(runs, 2U) << "one batch that warms up, one that would be counted";
}

}  // namespace
}  // namespace bezierbench::race
