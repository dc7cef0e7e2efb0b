// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/cli/choose/choose.hpp"

namespace bezierbench::cli {
namespace {

struct JudgedRow {
  std::string study, method, drawn, numbers;
};

/// Curves of degree 5 in Bernstein form on one axis; `drawn` is range, t_min and t_max, `numbers` max_error,
/// max_error_u, bound_u and max_bound.
tables::JudgedTables judged(const std::vector<JudgedRow>& rows, const std::string& unbounded = "0") {
  std::string accuracy =
      "study,form,method,scalar,dimension,degree,coordinate_range,t_min,t_max,generator,baseline,status,max_error,"
      "max_error_u,bound_u,max_bound,non_finite,unbounded_trials\n";
  for (const auto& row : rows)
    accuracy += row.study + ",bernstein," + row.method + ",double,1,5," + row.drawn + ",continuous,exact,ok," +
                row.numbers + ",0," + unbounded + "\n";
  std::vector<bundle::CsvDocument> accuracies;
  accuracies.push_back(bundle::parse_csv(accuracy, "accuracy.csv"));
  return tables::JudgedTables(std::move(accuracies));
}

/// The methods timed on curves of range 10 with t in [0,1].
tables::ChoiceGroup timed(const std::vector<std::string>& methods) {
  tables::ChoiceGroup group{"race", "", "bernstein", "double", "1", "5", "point", {"10", "0", "1", "continuous"}, {}};
  for (const auto& method : methods) group.choices.push_back({method, {1, 1, 1}, "ok", {}});
  return group;
}

bundle::CsvDocument methods_csv(const std::string& rows) {
  return bundle::parse_csv("id,problem,form,bound\n" + rows, "methods.csv");
}

constexpr auto own_methods = "de_casteljau,evaluation,bernstein,gamma_3n p~\n";

TEST(ClassChoice, TakesEveryRowWithinTheClass) {
  auto group = timed({"de_casteljau"});
  const auto tables = judged({{"truth", "de_casteljau", "10,0,1", "1,3,15,20"},
                              {"table", "de_casteljau", "10,0,1", "2,5,15,20"},
                              {"table", "de_casteljau", "1,0.2,0.8", "0.1,7,15,2"},
                              {"other", "de_casteljau", "100,0,1", "30,11,15,200"},
                              {"other", "de_casteljau", "10,-1,1", "40,12,15,900"}});
  const auto cells = judge_class(group, {10, {0, 1}}, tables, std::nullopt, "");
  EXPECT_EQ(cells,
            (std::vector<std::string>{"truth: R 10, t in [0, 1], continuous", "table: R 10, t in [0, 1], continuous",
                                      "table: R 1, t in [0.2, 0.8], continuous"}));
  ASSERT_EQ(group.choices.size(), 1U);
  EXPECT_EQ(group.choices[0].errors.in_u.observed, 7);
  EXPECT_EQ(group.choices[0].errors.absolute.observed, 2);
  EXPECT_EQ(group.choices[0].errors.in_u.bound, 15);
  EXPECT_FALSE(group.choices[0].errors.in_u.class_bound);  // without methods.csv the methods may differ from these
  EXPECT_EQ(group.accuracy_study, "truth, table");
  judge_class(group, {10, {0, 1}}, tables, std::nullopt, "truth");
  EXPECT_EQ(group.choices[0].errors.in_u.observed, 3);
}

/// Errors in u stay, those in coordinates grow with the curves; the bound of the class is that of the larger curves.
TEST(ClassChoice, ScalesByAPowerOfTwo) {
  const auto scaled = [](double range, const std::vector<double>& judged, bool in_float = false) {
    return scaled_to({range, {0, 1}}, 1, judged, in_float);
  };
  EXPECT_EQ(scaled(10, {1, 10})->exponent, 0);
  EXPECT_EQ(scaled(3, {1, 10})->range, 4);
  EXPECT_EQ(scaled(5, {1, 10})->range, 5) << "a half of 10";
  EXPECT_EQ(scaled(5, {1, 10})->exponent, -1);
  EXPECT_EQ(scaled(0.3, {1})->range, 0.5);
  EXPECT_EQ(scaled(7, {1, 8})->exponent, 3) << "that of the timed curves";
  EXPECT_FALSE(scaled(1e20, {1}, true));
  EXPECT_TRUE(scaled(1e20, {1}));
  EXPECT_FALSE(scaled(1e200, {1}));
  auto group = timed({"de_casteljau"});
  const auto cells = judge_class(group, *scaled(35, {10}), judged({{"truth", "de_casteljau", "10,0,1", "1,3,15,20"}}),
                                 methods_csv(own_methods), "");
  EXPECT_EQ(cells.size(), 1U);
  EXPECT_EQ(group.choices.at(0).errors.in_u.observed, 3);
  EXPECT_EQ(group.choices.at(0).errors.absolute.observed, 4);
  EXPECT_EQ(group.choices.at(0).errors.absolute.bound, 80);
  EXPECT_NEAR(*group.choices.at(0).errors.absolute.class_bound / (15 * 0x1p-53 * 40), 1, 1e-12);
}

TEST(ClassChoice, LeavesOutWhatWasJudgedOnAPartOfTheClassOnly) {
  auto group = timed({"de_casteljau", "direct"});
  judge_class(group, {10, {0, 1}},
              judged({{"s", "de_casteljau", "10,0,1", "1,3,15,20"}, {"s", "direct", "1,0,1", "1,2,17,20"}}),
              std::nullopt, "");
  ASSERT_EQ(group.choices.size(), 1U);
  EXPECT_EQ(group.choices[0].method, "de_casteljau");
}

TEST(ClassChoice, TrustsNoBoundOfAnotherVersionOfTheMethod) {
  auto group = timed({"de_casteljau"});
  judge_class(group, {10, {0, 1}}, judged({{"s", "de_casteljau", "10,0,1", "1,3,15,20"}}),
              methods_csv("de_casteljau,evaluation,bernstein,gamma_2n p~\n"), "");
  EXPECT_FALSE(group.choices.at(0).errors.in_u.class_bound);
}

TEST(ClassChoice, TakesTheClassFromTheRaceCell) {
  const auto tables =
      judged({{"s", "de_casteljau", "1,0,1", "1,3,15,20"}, {"s", "de_casteljau", "7,0,1", "1,3,15,20"}});
  auto group = timed({"de_casteljau"});
  EXPECT_EQ(class_of(group, {})->range, 10);
  EXPECT_EQ(class_of(group, 7.0)->range, 7);
  EXPECT_EQ(judged_ranges(group, tables, ""), (std::vector<double>{1, 7}));
  EXPECT_TRUE(judged_ranges(timed({"direct"}), tables, "").empty());
  EXPECT_TRUE(judged_ranges(group, tables, "other").empty());
  group.drawn.front() = "wide";
  EXPECT_FALSE(class_of(group, {}));
}

}  // namespace
}  // namespace bezierbench::cli
