// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/row_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

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

/// The kernel share of a bundle with this reference.csv.
std::optional<KernelShare> share_of(const std::string& table) {
  const ScratchFolder folder;
  BundleDirectory::create(folder.path() / "b").write("reference.csv", table);
  return kernel_share(folder.path() / "b");
}

TEST(KernelShare, IsTheSumOverCellsAndMethods) {
  const auto share = share_of("study,method,trials,own_kernel\ns,a,2000,2\ns,b,2000,2000\ns2,a,10,1\n");
  ASSERT_TRUE(share);
  EXPECT_EQ(share->judged, 4010U);
  EXPECT_EQ(share->own, 2003U);
}

TEST(KernelShare, IsUnknownOfOlderBundlesAndOthers) {
  EXPECT_FALSE(share_of("study,trials\ns,2000\n"));
  const ScratchFolder folder;
  (void)BundleDirectory::create(folder.path() / "b");
  EXPECT_FALSE(kernel_share(folder.path() / "b"));
}

TEST(KernelShare, NamesAFieldThatIsNoCount) {
  EXPECT_THROW((void)share_of("trials,own_kernel\n2000,many\n"), Failure);
  EXPECT_THROW((void)share_of("trials,own_kernel\n-1,1\n"), Failure);
}

}  // namespace

}  // namespace bezierbench::bundle
