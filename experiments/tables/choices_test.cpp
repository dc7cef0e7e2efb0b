// SPDX-License-Identifier: MIT
#include "experiments/tables/choices.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "experiments/failure.hpp"

namespace bezierbench::tables {
namespace {

constexpr auto timing_columns =
    "study,form,method,scalar,dimension,degree,mode,median_ns,low_ns,high_ns,quality,"
    "coordinate_range,t_min,t_max,generator\n";
constexpr auto accuracy_columns_needed =
    "study,form,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator,baseline,status,max_error,"
    "max_error_u,bound_u,max_bound,non_finite\n";
constexpr auto reference_columns_needed =
    "study,form,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator,unbounded_trials\n";

bundle::CsvDocument timing(const std::string& rows) { return bundle::parse_csv(timing_columns + rows, "timing.csv"); }
/// `counts`: rows of reference.csv with the numbers of trials that have no bound.
JudgedTables judged(const std::string& rows, const std::string& counts = "") {
  std::vector<bundle::CsvDocument> accuracies;
  accuracies.push_back(bundle::parse_csv(accuracy_columns_needed + rows, "accuracy.csv"));
  return {std::move(accuracies), bundle::parse_csv(reference_columns_needed + counts, "reference.csv")};
}

std::string time_of(const std::string& method, const std::string& ns, const std::string& mode = "point") {
  return "speed,bernstein," + method + ",double,2,3," + mode + "," + ns + "," + ns + "," + ns +
         ",ok,1,0,1,continuous\n";
}
std::string error_of(const std::string& study, const std::string& method, const std::string& numbers,
                     const std::string& baseline = "exact", const std::string& drawn = "1,0,1") {
  return study + ",bernstein," + method + ",double,2,3," + drawn + ",continuous," + baseline + ",ok," + numbers + "\n";
}
std::string unbounded(const std::string& study, const std::string& method, const std::string& trials,
                      const std::string& drawn = "1,0,1") {
  return study + ",bernstein," + method + ",double,2,3," + drawn + ",continuous," + trials + "\n";
}

TEST(ChoiceGroups, TakeTheWorstOfAllCellsOfAStudy) {
  const auto groups = choice_groups(timing(time_of("a", "5")), judged(error_of("s", "a", "1e-16,2,9,1e-15,0") +
                                                                          error_of("s", "a", "3e-16,1.5,8,2e-15,0"),
                                                                      unbounded("s", "a", "0")));
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].choices.size(), 1U);
  const Choice& choice = groups[0].choices[0];
  EXPECT_EQ(choice.ns.median, 5);
  EXPECT_EQ(choice.errors.in_u.observed, 2);
  EXPECT_EQ(choice.errors.in_u.bound, 9);
  EXPECT_EQ(choice.errors.absolute.observed, 3e-16);
  EXPECT_EQ(choice.errors.absolute.bound, 2e-15);
}

TEST(ChoiceGroups, HaveNoBoundWhereACellHasNone) {
  const auto groups = choice_groups(
      timing(time_of("a", "5")),
      judged(error_of("s", "a", "1,2,9,9,0") + error_of("s", "a", "1,2,,,0") + error_of("s", "a", "1,2,7,7,0"),
             unbounded("s", "a", "0")));
  EXPECT_FALSE(groups.at(0).choices.at(0).errors.in_u.bound);
}

/// bound_u is the largest over the trials that have a bound; it does not apply to the others.
TEST(ChoiceGroups, HaveNoBoundWhereATrialHasNone) {
  const auto errors = error_of("s", "a", "1,2031,44,9,0") + error_of("s", "a", "1,2,44,9,0", "exact", "5,0,1");
  const auto bound = [&](const std::string& counts) {
    return choice_groups(timing(time_of("a", "5")), judged(errors, counts)).at(0).choices.at(0).errors.in_u.bound;
  };
  EXPECT_EQ(bound(unbounded("s", "a", "0") + unbounded("s", "a", "0", "5,0,1")), 44);
  EXPECT_FALSE(bound(unbounded("s", "a", "3") + unbounded("s", "a", "0", "5,0,1")));
  EXPECT_FALSE(bound(unbounded("s", "a", "0") + unbounded("s", "a", "1", "5,0,1")));
  EXPECT_FALSE(bound(unbounded("s", "a", "0")));  // the other row has no count, as in older bundles
}

/// Since schema version 2 the rows have this count themselves.
TEST(ChoiceGroups, HaveNoBoundWhereTheRowCountsATrialWithout) {
  const auto bound = [&](const std::string& trials) {
    std::vector<bundle::CsvDocument> accuracies;
    accuracies.push_back(bundle::parse_csv(
        std::string("unbounded_trials,") + accuracy_columns_needed + trials + "," + error_of("s", "a", "1,2,44,9,0"),
        "a.csv"));
    const JudgedTables tables(std::move(accuracies), std::nullopt);
    return choice_groups(timing(time_of("a", "5")), tables).at(0).choices.at(0).errors.in_u.bound;
  };
  EXPECT_EQ(bound("0"), 44);
  EXPECT_FALSE(bound("3"));
  EXPECT_FALSE(bound(""));
}

TEST(ChoiceGroups, CountAResultThatIsNotFiniteAsInfinitelyWrong) {
  const auto groups = choice_groups(timing(time_of("a", "5")), judged(error_of("s", "a", "1,2,9,9,1")));
  EXPECT_EQ(groups.at(0).choices.at(0).errors.in_u.observed, std::numeric_limits<double>::infinity());
}

TEST(ChoiceGroups, TakeErrorsAgainstTheTruthOnly) {
  EXPECT_TRUE(choice_groups(timing(time_of("a", "5")), judged(error_of("s", "a", "1,2,9,9,0", "direct"))).empty());
}

TEST(ChoiceGroups, TakeTheStudyThatJudgedMostOfTheTimedMethods) {
  const auto times = timing(time_of("a", "5") + time_of("b", "6"));
  const auto errors = judged(error_of("few", "a", "9,9,9,9,0") + error_of("most", "a", "1,1,9,9,0") +
                             error_of("most", "b", "2,2,9,9,0"));
  const auto groups = choice_groups(times, errors);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].accuracy_study, "most");
  EXPECT_EQ(groups[0].choices.size(), 2U);
  const auto asked = choice_groups(times, errors, "few");
  EXPECT_EQ(asked.at(0).accuracy_study, "few");
  ASSERT_EQ(asked[0].choices.size(), 1U);  // b was not judged there
  EXPECT_EQ(asked[0].choices[0].errors.in_u.observed, 9);
}

TEST(ChoiceGroups, KeepHeatsApart) {
  const auto groups =
      choice_groups(timing(time_of("a", "5") + time_of("a", "2", "batch")), judged(error_of("s", "a", "1,2,9,9,0")));
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[1].mode, "batch");
}

TEST(ChoiceGroups, SayWhereANumberIsNone) {
  EXPECT_THROW((void)choice_groups(timing(time_of("a", "quick")), judged(error_of("s", "a", "1,2,9,9,0"))), Failure);
}

}  // namespace
}  // namespace bezierbench::tables
