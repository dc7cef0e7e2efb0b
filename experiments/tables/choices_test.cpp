// SPDX-License-Identifier: MIT
#include "experiments/tables/choices.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/failure.hpp"

namespace bezierbench::tables {
namespace {

/// The errors of a method: max_error, max_error_u, bound_u, max_bound.
struct Numbers {
  double max_error, max_error_u;
  std::optional<double> bound_u, max_bound;
};

Row in_cell(const char* file, const std::string& study, const std::string& method) {
  return Row(file)
      .set("study", study)
      .set("form", "bernstein")
      .set("method", method)
      .set("scalar", "double")
      .set("dimension", 2)
      .set("degree", 3)
      .set("coordinate_range", 1)
      .set("t_min", 0)
      .set("t_max", 1)
      .set("generator", "continuous");
}

Row time_of(const std::string& method, double ns, const std::string& mode = "point") {
  return in_cell("timing.csv", "speed", method)
      .set("mode", mode)
      .set("median_ns", ns)
      .set("low_ns", ns)
      .set("high_ns", ns)
      .set("quality", "ok");
}

Row error_of(const std::string& study, const std::string& method, const Numbers& numbers, int unbounded = 0,
             int non_finite = 0, const std::string& baseline = "exact") {
  return in_cell("accuracy.csv", study, method)
      .set("baseline", baseline)
      .set("status", "ok")
      .set("max_error", numbers.max_error)
      .set("max_error_u", numbers.max_error_u)
      .set("bound_u", numbers.bound_u)
      .set("max_bound", numbers.max_bound)
      .set("non_finite", non_finite)
      .set("unbounded_trials", unbounded);
}

std::vector<ChoiceGroup> groups_of(const std::vector<Row>& rows) {
  Tables tables;
  for (const auto& row : rows) tables.add(row);
  return choice_groups(rows_of(tables.table("timing.csv")), JudgedTables(tables));
}

TEST(ChoiceGroups, TakeTheWorstOfAllCellsOfAStudy) {
  const auto groups = groups_of(
      {time_of("a", 5), error_of("s", "a", {1e-16, 2, 9, 1e-15}), error_of("s", "a", {3e-16, 1.5, 8, 2e-15})});
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].choices.size(), 1U);
  const Choice& choice = groups[0].choices[0];
  EXPECT_EQ(choice.ns.median, 5);
  EXPECT_EQ(choice.errors.in_u.observed, 2);
  EXPECT_EQ(choice.errors.in_u.bound, 9);
  EXPECT_EQ(choice.errors.absolute.observed, 3e-16);
  EXPECT_EQ(choice.errors.absolute.bound, 2e-15);
}

/// Times of a set are joined with the errors of this set and placement, not with those of other sets in the same study.
TEST(ChoiceGroups, JoinTheErrorsOfTheSameSetAndPlacement) {
  const auto of_set = [](Row row, const std::string& curves, const std::string& placement) {
    row.replace("curves", curves);
    row.replace("generator", placement);
    return row;
  };
  const auto groups = groups_of(
      {of_set(time_of("a", 5), "icons", "stored"), of_set(error_of("s", "a", {1, 2, 9, 9}), "icons", "stored"),
       of_set(error_of("s", "a", {1, 4, 9, 9}), "icons", "translated"),
       of_set(error_of("s", "a", {1, 8, 9, 9}), "fonts", "stored"), error_of("s", "a", {1, 16, 9, 9})});
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].choices.size(), 1U);
  EXPECT_EQ(groups[0].choices[0].errors.in_u.observed, 2);
}

TEST(ChoiceGroups, HaveNoBoundWhereACellHasNone) {
  const auto groups =
      groups_of({time_of("a", 5), error_of("s", "a", {1, 2, 9, 9}),
                 error_of("s", "a", {1, 2, std::nullopt, std::nullopt}), error_of("s", "a", {1, 2, 7, 7})});
  EXPECT_FALSE(groups.at(0).choices.at(0).errors.in_u.bound);
}

/// bound_u is the largest over the trials that have a bound; it does not apply to the others.
TEST(ChoiceGroups, HaveNoBoundWhereATrialHasNone) {
  const auto bound = [](int unbounded) {
    return groups_of(
               {time_of("a", 5), error_of("s", "a", {1, 2031, 44, 9}), error_of("s", "a", {1, 2, 44, 9}, unbounded)})
        .at(0)
        .choices.at(0)
        .errors.in_u.bound;
  };
  EXPECT_EQ(bound(0), 44);
  EXPECT_FALSE(bound(3));
}

TEST(ChoiceGroups, CountAResultThatIsNotFiniteAsInfinitelyWrong) {
  const auto groups = groups_of({time_of("a", 5), error_of("s", "a", {1, 2, 9, 9}, 0, 1)});
  EXPECT_EQ(groups.at(0).choices.at(0).errors.in_u.observed, std::numeric_limits<double>::infinity());
}

TEST(ChoiceGroups, TakeErrorsAgainstTheTruthOnly) {
  EXPECT_TRUE(groups_of({time_of("a", 5), error_of("s", "a", {1, 2, 9, 9}, 0, 0, "direct")}).empty());
}

TEST(ChoiceGroups, TakeTheStudyThatJudgedMostOfTheTimedMethods) {
  const auto groups =
      groups_of({time_of("a", 5), time_of("b", 6), error_of("few", "a", {9, 9, 9, 9}),
                 error_of("most", "a", {1, 1, 9, 9}), error_of("most", "b", {2, 2, 9, 9}), time_of("c", 7)});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].accuracy_study, "most");
  EXPECT_EQ(groups[0].choices.size(), 2U) << "c was not judged there";
}

TEST(ChoiceGroups, KeepHeatsApart) {
  const auto groups = groups_of({time_of("a", 5), time_of("a", 2, "batch"), error_of("s", "a", {1, 2, 9, 9})});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[1].mode, "batch");
}

TEST(ChoiceGroups, SayWhereANumberOfAFileIsNone) {
  const auto timing = bundle::parse_csv(
      "study,form,method,scalar,dimension,degree,mode,median_ns,low_ns,high_ns,quality\n"
      "speed,bernstein,a,double,2,3,point,quick,1,1,ok\n",
      "timing.csv");
  EXPECT_THROW((void)timed_groups(rows_of(timing)), Failure);
}

}  // namespace
}  // namespace bezierbench::tables
