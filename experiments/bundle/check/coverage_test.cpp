// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/coverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace bezierbench::bundle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string head = "study,method,scalar,dimension,degree,property\n";
const std::string list = "id,problem,form,bound\n";

/// The faults of a bundle with these rows and methods, held to the plan of a build with the methods a and b.
std::vector<std::string> faults(const std::string& rows, const std::string& methods,
                                const std::string& commit = "unknown") {
  Plan plan;
  plan.external = {"plugin_p"};
  plan.rows.emplace("guarantees.csv",
                    parse_csv(head + "s,a,double,2,1,finite\ns,b,double,2,1,finite\n", "guarantees.csv"));
  plan.methods_csv = list + "a,evaluation,bernstein,1 u\nb,evaluation,bernstein,2 u\n";
  plan.git_commit = "0";
  TablesByName tables;
  tables.emplace("guarantees.csv", parse_csv(head + rows, "guarantees.csv"));
  tables.emplace("methods.csv", parse_csv(list + methods, "methods.csv"));
  return coverage_faults(plan, tables, commit, "f");
}

const std::string a = "a,evaluation,bernstein,1 u\n";
const std::string b = "b,evaluation,bernstein,2 u\n";

TEST(Coverage, OfAllPlannedRows) {
  EXPECT_THAT(faults("s,a,double,2,1,finite\ns,b,double,2,1,finite\n", a + b), IsEmpty());
  EXPECT_THAT(faults("s,a,double,2,1,finite\n", a + b),
              ElementsAre("f/guarantees.csv: the row with study s, method b, scalar double, dimension 2, degree 1, "
                          "property finite is missing, suite.toml asks for it"));
}

TEST(Coverage, OfNoOtherRows) {
  const std::string good = "s,a,double,2,1,finite\ns,b,double,2,1,finite\n";
  EXPECT_THAT(faults(good + "s,a,double,2,9,finite\n", a + b), ElementsAre(HasSubstr("asks for no row with study s")));
  EXPECT_THAT(faults(good + "s,c,double,2,1,finite\n", a + b), ElementsAre(HasSubstr("method c")));
  EXPECT_THAT(faults(good + "other,a,double,2,9,finite\n", a + b), IsEmpty());  // of which nothing is planned
}

/// In a table where none of its rows is planned, an external method has some where it did not fail.
TEST(Coverage, OfExternalMethodsWhereNoneIsPlanned) {
  const std::string good = "s,a,double,2,1,finite\ns,b,double,2,1,finite\n";
  EXPECT_THAT(faults(good + "s,plugin_p,double,2,1,finite\n", a + b), IsEmpty());
  EXPECT_THAT(faults(good + "s,plugin_q,double,2,1,finite\n", a + b), ElementsAre(HasSubstr("method plugin_q")));
}

/// Of a method that the other build did not have, or had otherwise, and of one that this build does not have.
TEST(Coverage, OfAnotherBuildIsWhatItsListSays) {
  EXPECT_THAT(faults("s,a,double,2,1,finite\n", a), IsEmpty());
  EXPECT_THAT(faults("s,a,double,2,1,finite\ns,b,double,2,9,finite\n", a + "b,evaluation,bernstein,3 u\n"), IsEmpty());
  EXPECT_THAT(faults("s,a,double,2,1,finite\ns,b,double,2,1,finite\ns,c,double,2,1,finite\n",
                     a + b + "c,evaluation,bernstein,\n"),
              IsEmpty());
}

/// A later build may ask for more properties, but of those that there are each method has its row.
TEST(Coverage, OfAnotherCommitLacksWhatNoMethodHas) {
  EXPECT_EQ(faults("s,a,double,2,9,finite\n", a, "1").size(), 1U);  // the row at degree 9
  EXPECT_EQ(faults("s,a,double,2,9,finite\n", a).size(), 2U);
  EXPECT_EQ(faults("s,a,double,2,1,finite\n", a + b, "1").size(), 1U);
}

TEST(Coverage, NamesWhatTheListLacks) {
  EXPECT_THAT(faults("s,a,double,2,1,finite\ns,b,double,2,1,finite\n", a),
              ElementsAre("f/guarantees.csv:3: methods.csv does not list its method b"));
}

TEST(Coverage, OfTheSameCommitHasTheSameList) {
  EXPECT_THAT(faults("s,a,double,2,1,finite\n", a + "b,evaluation,bernstein,3 u\n", "0"),
              ElementsAre(HasSubstr("methods.csv: id b, problem evaluation, form bernstein is not described as by")));
}

}  // namespace
}  // namespace bezierbench::bundle
