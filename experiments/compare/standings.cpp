// SPDX-License-Identifier: MIT
#include "experiments/compare/standings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "experiments/compare/comparison.hpp"
#include "experiments/tables/table_row.hpp"

namespace bezierbench::compare {
namespace {

/// The inputs of the timings that all bundles have in common, without those of sentinels; a bundle that has none in
/// common with the first is not counted.
std::set<Inputs> common_timings(const std::vector<Comparison>& comparisons) {
  std::optional<std::set<Inputs>> common;
  for (const auto& comparison : comparisons) {
    std::set<Inputs> here;
    for (const auto& row : comparison.times)
      if (!row.is_sentinel()) here.insert(row.inputs);
    if (here.empty()) continue;
    if (!common) common = here;
    std::erase_if(*common, [&](const Inputs& inputs) { return !here.contains(inputs); });
  }
  return common.value_or(std::set<Inputs>{});
}

/// Whether one side resolves x as the faster and the other side y.
bool changed_places(const Timed& x, const Timed& y) {
  using metric::Verdict;
  const auto in_a = metric::verdict(ratio(x.a, y.a));
  const auto in_b = metric::verdict(ratio(x.b, y.b));
  return (in_a == Verdict::faster && in_b == Verdict::slower) || (in_a == Verdict::slower && in_b == Verdict::faster);
}

}  // namespace

void rank(std::vector<Comparison>& comparisons) {
  const auto common = common_timings(comparisons);
  for (auto& comparison : comparisons) {
    std::map<Inputs, std::vector<Timed*>> races;
    for (auto& row : comparison.times)
      if (common.contains(row.inputs)) races[row.inputs.without_method()].push_back(&*row.timed);
    for (const auto& race : races)
      for (auto* one : race.second) {
        const auto faster = [&](metric::Interval Timed::*side) {
          const auto ends_before = [&](const Timed* rival) { return (rival->*side).high < (one->*side).low; };
          return static_cast<int>(std::ranges::count_if(race.second, ends_before));
        };
        one->rank_a = 1 + faster(&Timed::a);
        one->rank_b = 1 + faster(&Timed::b);
        one->changed_place =
            std::ranges::any_of(race.second, [one](const Timed* rival) { return changed_places(*one, *rival); });
      }
  }
}

std::vector<Standing> standings(const std::vector<Comparison>& comparisons) {
  const auto common = common_timings(comparisons);
  std::vector<Standing> all{{.side = comparisons.front().a, .timings = common.size()}};
  if (!common.empty()) all.front().mean_ratio = all.front().mean_normalised = 1;
  for (const auto& comparison : comparisons) {
    Standing one{
        .side = comparison.b, .same_machine = comparison.same_machine, .differing = comparison.differing().size()};
    double logarithms = 0;
    double normalised = 0;
    for (const auto& row : comparison.times) {
      if (!common.contains(row.inputs)) continue;
      ++one.timings;
      logarithms += std::log(row.ratio.median);
      normalised +=
          row.timed->normalised ? std::log(row.timed->normalised->median) : std::numeric_limits<double>::quiet_NaN();
    }
    const auto mean = [&](double sum) { return std::exp(sum / static_cast<double>(one.timings)); };
    if (one.timings > 0) {
      one.mean_ratio = mean(logarithms);
      one.mean_normalised = mean(normalised);
    }
    all.push_back(one);
  }
  const auto ratio_or_last = [](const Standing& one) {
    return one.timings > 0 ? one.mean_ratio : std::numeric_limits<double>::infinity();
  };
  std::ranges::stable_sort(all, {}, ratio_or_last);
  for (auto& one : all) {
    const auto is_faster = [&](const Standing& rival) { return ratio_or_last(rival) < ratio_or_last(one); };
    if (one.timings > 0) one.rank = 1 + std::ranges::count_if(all, is_faster);
  }
  return all;
}

bundle::CsvTable standings_table(const std::vector<Standing>& standings) {
  bundle::CsvTable table({"rank", "bundle", "cpu", "compiler", "machine", "accuracy_rows_differing", "timings",
                          "mean_ratio", "mean_normalised"});
  for (const auto& one : standings)
    table.add_row(tables::texts(one.rank, one.side->name, one.side->fact("cpu.model_name"),
                                one.side->fact("build.compiler"), one.same_machine ? "same" : "other", one.differing,
                                one.timings, one.mean_ratio, one.mean_normalised));
  return table;
}

}  // namespace bezierbench::compare
