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
  return row_faults(file, parse_csv(text, file), {"promising"});
}

TEST(RowRules, AnErrorIsNotAboveItsBoundWhereEveryTrialHasOne) {
  const std::string header = "method,max_error_u,bound_u,unbounded_trials\n";
  EXPECT_THAT(faults("accuracy.csv", header + "a,12,12,0\nb,13,12,1\nc,13,,13\nd,12.000001,12,0\n"), IsEmpty());
  EXPECT_THAT(faults("accuracy.csv", header + "a,12,12,0\nb,13,12,0\n"),
              ElementsAre("accuracy.csv:3: max_error_u is above bound_u"));
}

/// The bound of a trial whose result is not finite must be infinite, and such a trial counts as unbounded.
TEST(RowRules, AResultThatIsNotFiniteHasNoFiniteBound) {
  const std::string header = "method,bound_violations,non_finite,unbounded_trials\n";
  EXPECT_THAT(faults("accuracy.csv", header + "a,0,3,3\nb,0,0,5\nc,,4,\n"), IsEmpty());
  EXPECT_THAT(faults("accuracy.csv", header + "a,0,3,2\n"),
              ElementsAre("accuracy.csv:2: non_finite is above unbounded_trials"));
}

TEST(RowRules, AResidualIsNotAboveItsBoundWhereNoTrialFailed) {
  const std::string header = "method,max_residual,residual_bound,non_converged\n";
  EXPECT_THAT(faults("projection.csv", header + "a,5,6,0\nb,7,6,1\nc,7,,0\n"), IsEmpty());
  EXPECT_THAT(faults("projection.csv", header + "a,7,6,0\n"),
              ElementsAre("projection.csv:2: max_residual is above residual_bound"));
}

TEST(RowRules, BrokenPromisesAccuseEverywhereAndMissedFeetThoseThatPromise) {
  for (const char* file :
       {"projection.csv", "arc_length.csv", "inverse_arc_length.csv", "fitting.csv", "subdivision.csv"})
    EXPECT_THAT(faults(file, "method,broken_promises\na,2\nb,0\n"),
                ElementsAre(std::string(file) + ":2: 2 broken promises"));
  EXPECT_THAT(faults("projection.csv", "method,missed\npromising,1\nother,1\n"),
              ElementsAre("projection.csv:2: 1 missed foot points"));
}

}  // namespace
}  // namespace bezierbench::bundle
