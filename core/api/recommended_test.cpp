// SPDX-License-Identifier: MIT
// The choice against the committed bundle results/answers, which it is made from.
#include "core/api/recommended.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/evaluate/roster.hpp"
#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/csv.hpp"
#include "reference/number/number.hpp"

namespace bezierbench {
namespace {

bundle::CsvDocument table(const std::string& name) {
  const std::string file = BEZIERBENCH_SOURCE_DIR "/results/answers/" + name;
  return bundle::parse_csv(bundle::read_file(file), file);
}

double number_at(const bundle::CsvDocument& of, std::size_t row, std::string_view column) {
  return number::parse_number(of.at(row, column)).value();
}

/// Over the degrees of some studies: how many were timed, the product of the times, and of the errors.
struct Seen {
  int degrees = 0;
  double times = 1;
  double errors = 1;
  bool proved = true;
};

/// The ids of the methods with fused operations.
std::set<std::string> fused_methods() {
  std::set<std::string> fused;
  for (const MethodInfo* method : infos_of(Evaluators()))
    if (method->fused) fused.emplace(method->id);
  return fused;
}

/// Adds a study to what was seen of the methods that need neither a conversion nor a fused operation, by id.
void see(const std::string& study, const std::set<int>& degrees, std::map<std::string, Seen>& all) {
  const auto fused = fused_methods();
  const auto has_degree = [&](const bundle::CsvDocument& of, std::size_t row) {
    const auto degree = number::parse_integer(of.at(row, "degree"));
    return degree && degrees.contains(static_cast<int>(*degree));
  };
  const auto timing = table("timing.csv");
  for (std::size_t row = 0; row < timing.row_count(); ++row) {
    const auto& id = timing.at(row, "method");
    if (timing.at(row, "study") != study + "-time" || timing.at(row, "mode") != "point" || !has_degree(timing, row) ||
        id.find(':') != std::string::npos || fused.contains(id))
      continue;
    all[id].times *= number_at(timing, row, "median_ns");
    ++all[id].degrees;
  }
  const auto accuracy = table("accuracy.csv");
  for (std::size_t row = 0; row < accuracy.row_count(); ++row) {
    const auto found = all.find(accuracy.at(row, "method"));
    if (accuracy.at(row, "study") != study || !has_degree(accuracy, row) || found == all.end()) continue;
    auto& seen = found->second;
    seen.proved =
        seen.proved && !accuracy.at(row, "bound_u").empty() && number_at(accuracy, row, "unbounded_trials") == 0;
    if (seen.proved) seen.errors *= number_at(accuracy, row, "max_error_u");
  }
}

/// The methods with a proof that the rule of recommended.hpp does not find too slow.
std::map<std::string, Seen> fast_enough(const std::vector<std::string>& studies, const std::set<int>& degrees) {
  std::map<std::string, Seen> all;
  for (const auto& study : studies) see(study, degrees, all);
  std::erase_if(all, [&](const auto& one) {
    return one.second.degrees < static_cast<int>(degrees.size() * studies.size()) || !one.second.proved;
  });
  const auto fastest = std::ranges::min_element(all, {}, [](const auto& one) { return one.second.times; });
  const double most = 1.2 * fastest->second.times;
  std::erase_if(all, [&](const auto& one) { return one.second.times > most; });
  return all;
}

/// The method that the rule of recommended.hpp names.
std::string chosen_by_rule(const std::vector<std::string>& studies) {
  const auto fast = fast_enough(studies, {3, 5, 12, 30});
  return std::ranges::min_element(fast, {}, [](const auto& one) { return one.second.errors; })->first;
}

TEST(Recommended, IsWhatTheCommittedTablesSay) {
  for (const int degree : {3, 5, 12, 30}) {
    EXPECT_EQ(recommended(degree).id, chosen_by_rule({"answers-bezier", "answers-outside"}));
    EXPECT_EQ(recommended<Form::rational>(degree).id, chosen_by_rule({"answers-rational"}));
  }
  EXPECT_EQ(recommended<Form::power>(12).id, chosen_by_rule({"answers-power"}));
  EXPECT_EQ(recommended<Form::power>(30).id, chosen_by_rule({"answers-power"}));
}

TEST(Recommended, IsAsFastAtLowDegreesOfThePowerForm) {
  for (const int degree : {3, 5}) {
    const std::string chosen(recommended<Form::power>(degree).id);
    EXPECT_TRUE(fast_enough({"answers-power"}, {degree}).contains(chosen)) << chosen << " at " << degree;
  }
}

}  // namespace
}  // namespace bezierbench
