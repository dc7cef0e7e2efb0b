// SPDX-License-Identifier: MIT
#include "experiments/compare/gates.hpp"

#include <gtest/gtest.h>

#include "experiments/compare/side_test.hpp"

namespace bezierbench::compare {
namespace {

constexpr double threshold = 0.05;

/// The ruling on the only row of two sides.
Ruled ruled(Gate gate, const Side& a, const Side& b, double beyond = threshold) {
  const auto comparison = compare_sides(a, b);
  const auto report = rule(gate, comparison, beyond);
  EXPECT_EQ(report.rows.size(), 1U);
  return {nullptr, report.rows.at(0).ruling, report.rows.at(0).why};
}

Ruling on_times(const std::string& a, const std::string& b) {
  return ruled(Gate::slower, timed("a", a), timed("b", b)).ruling;
}

TEST(SlowerGate, FailsWhereTheWholeIntervalIsBeyondTheThreshold) {
  EXPECT_EQ(on_times(timing_row("x", 10), timing_row("x", 10)), Ruling::passes);
  EXPECT_EQ(on_times(timing_row("x", 10), timing_row("x", 10.4)), Ruling::passes);
  EXPECT_EQ(on_times(timing_row("x", 10), timing_row("x", 11)), Ruling::fails);
  EXPECT_EQ(on_times(timing_row("x", 10), timing_row("x", 5)), Ruling::passes) << "faster";
  EXPECT_EQ(on_times(timing_row("x", 10, {.spread = 0.1}), timing_row("x", 11, {.spread = 0.1})), Ruling::undecided);
  EXPECT_EQ(on_times(timing_row("x", 10, {.quality = "few_rounds"}), timing_row("x", 20)), Ruling::undecided);
  EXPECT_EQ(on_times(timing_row("x", 10, {.units = "10"}), timing_row("x", 20, {.units = "10"})), Ruling::passes)
      << "on another machine, whose sentinel took twice as long as well";
}

/// The ruling on a row of accuracy.csv; `fields` are status, mean_error_u, max_error_u and bound_violations.
Ruled on_errors(const std::string& a, const std::string& b) {
  const auto side = [](const std::string& name, const std::string& fields) {
    return side_of(name, {{"accuracy.csv",
                           "study,method,status,mean_error_u,max_error_u,bound_violations\ns,x," + fields + "\n"}});
  };
  return ruled(Gate::less_accurate, side("a", a), side("b", b));
}

TEST(LessAccurateGate, FailsOnGrowthBeyondTheThreshold) {
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,1,2,0").ruling, Ruling::passes);
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,1.04,2,0").ruling, Ruling::passes);
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,0.5,1,0").ruling, Ruling::passes) << "more accurate";
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,1.1,1,0").ruling, Ruling::fails) << "the mean alone";
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,1.01,3,0").why, "max_error_u is 1.5 times as large");
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,0.8,3,0").ruling, Ruling::passes) << "the largest of a sample, by chance";
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,0.8,5,0").ruling, Ruling::fails);
  EXPECT_EQ(on_errors("ok,0,0,0", "ok,1e-20,0,0").ruling, Ruling::fails) << "it was exact";
  EXPECT_EQ(on_errors("ok,1,inf,0", "ok,1,2,0").ruling, Ruling::passes);
}

TEST(LessAccurateGate, FailsOnWhatBroke) {
  EXPECT_EQ(on_errors("ok,1,2,0", "ok,1,2,3").why, "bound violations");
  EXPECT_EQ(on_errors("ok,1,2,3", "ok,1,2,4").ruling, Ruling::passes) << "broken before";
  EXPECT_EQ(on_errors("ok,1,2,0", "degree_unsupported,,,").why, "status degree_unsupported");
  const auto side = [](const std::string& name, const std::string& verdict) {
    return side_of(name, {{"guarantees.csv", "study,method,property,verdict\ns,x,in_hull," + verdict + "\n"}});
  };
  const auto on_verdicts = [&](const std::string& a, const std::string& b) {
    return ruled(Gate::less_accurate, side("a", a), side("b", b));
  };
  EXPECT_EQ(on_verdicts("not_refuted", "refuted").why, "in_hull is refuted");
  EXPECT_EQ(on_verdicts("refuted", "not_refuted").ruling, Ruling::passes);
}

/// The ruling on the instructions of one kernel.
Ruled on_costs(double a, double b) {
  const auto side = [](const std::string& name, double instructions) {
    return side_of(name, {{"cost.csv", fmt::format("study,method,target,instructions\ns,x,,{}\n", instructions)}});
  };
  return ruled(Gate::costlier, side("a", a), side("b", b));
}

TEST(CostlierGate, DecidesByTheCount) {
  EXPECT_EQ(on_costs(40, 40).ruling, Ruling::passes);
  EXPECT_EQ(on_costs(40, 42).ruling, Ruling::passes) << "the threshold itself";
  EXPECT_EQ(on_costs(40, 42.5).why, "42.5 instead of 40 instructions");
  EXPECT_EQ(on_costs(40, 30).ruling, Ruling::passes);
}

TEST(CostlierGate, ComparesOneCompilerOnly) {
  const std::string table = "study,method,target,instructions\ns,x,,40\n";
  auto a = side_of("a", {{"cost.csv", table}});
  auto b = a;
  a.facts = {{"build.compiler", "GCC"}};
  b.facts = {{"build.compiler", "Clang"}};
  const auto comparison = compare_sides(a, b);
  EXPECT_TRUE(rule(Gate::costlier, comparison, threshold).rows.empty());
}

}  // namespace
}  // namespace bezierbench::compare
