// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/row_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace bezierbench::bundle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> faults(const std::string& file, const std::string& text) {
  return row_faults(file, parse_csv(text, file), {.promising = {"a"}, .external = {"own"}});
}

TEST(RowRules, BrokenPromisesAccuseEverywhereAndMissedFeetThoseThatPromise) {
  for (const char* file :
       {"projection.csv", "arc_length.csv", "inverse_arc_length.csv", "fitting.csv", "subdivision.csv"})
    EXPECT_THAT(faults(file, "method,broken_promises\na,2\nb,0\n"),
                ElementsAre(std::string(file) + ":2: 2 broken promises"));
  EXPECT_THAT(faults("projection.csv", "method,missed\na,1\nown,1\nb,1\n"),
              ElementsAre("projection.csv:2: 1 missed foot points"));
  EXPECT_THAT(faults("timing.csv", "method,checked\na,yes\nb,no\nown,no\n"),
              ElementsAre("timing.csv:4: what was timed did not give what was judged"));
}

}  // namespace
}  // namespace bezierbench::bundle
