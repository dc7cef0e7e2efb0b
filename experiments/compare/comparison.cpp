// SPDX-License-Identifier: MIT
#include "experiments/compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "experiments/number/number.hpp"

namespace bezierbench::compare {
namespace {

using Fields = std::vector<std::string>;

// The columns of comparison.csv; the contract lists `kind` and those of the first two arrays.
constexpr std::array<std::string_view, 6> leading_inputs{"study", "method", "scalar", "dimension", "degree", "mode"};
constexpr std::array<std::string_view, 6> results{"a", "b", "ratio", "ratio_low", "ratio_high", "verdict"};
constexpr std::array<std::string_view, 8> further_inputs{"table", "form",      "coordinate_range", "t_min",
                                                         "t_max", "generator", "trials",           "baseline"};
constexpr std::array<std::string_view, 11> explanations{"against",        "bundle",          "file",
                                                        "column",         "quality",         "normalised",
                                                        "normalised_low", "normalised_high", "normalised_verdict",
                                                        "rank_a",         "rank_b"};

/// A line of comparison.csv. `of_results` are the fields of `results`, `of_explanations` those that follow `bundle`; fields that are left out at the end are empty.
Fields line(std::string_view kind, const Pair& pair, const Inputs& inputs, const Fields& of_results,
            const Fields& of_explanations) {
  Fields fields{std::string(kind)};
  for (const auto name : leading_inputs) fields.push_back(inputs.field(name));
  fields.insert(fields.end(), of_results.begin(), of_results.end());
  for (const auto name : further_inputs) fields.push_back(inputs.field(name));
  fields.insert(fields.end(), {pair.against, pair.bundle});
  fields.insert(fields.end(), of_explanations.begin(), of_explanations.end());
  fields.resize(1 + leading_inputs.size() + results.size() + further_inputs.size() + explanations.size());
  return fields;
}

Fields accuracy_line(const Pair& pair, const AccuracyRow& row) {
  const auto a = number::parse_number(row.first.a);
  const auto b = number::parse_number(row.first.b);
  const auto ratio = a && b && *a != 0 ? number::decimal(*b / *a) : "";
  return line("accuracy", pair, row.inputs,
              {row.first.a, row.first.b, ratio, "", "", row.identical ? "identical" : "different"},
              {row.file, row.first.column});
}

/// The fields of a ratio, its interval and its verdict; empty without one.
Fields ratio_fields(const std::optional<TimeRatio>& of) {
  if (!of) return {"", "", "", ""};
  return {number::decimal(of->ratio.median), number::decimal(of->ratio.low), number::decimal(of->ratio.high),
          std::string(metric::name(of->verdict))};
}

Fields timing_line(const Pair& pair, const TimingRow& row) {
  Fields of_results{number::decimal(row.a.median), number::decimal(row.b.median)};
  for (auto& field : ratio_fields(row.raw)) of_results.push_back(std::move(field));
  Fields of_explanations{timing_file, "median_ns", row.quality};
  for (auto& field : ratio_fields(row.normalised)) of_explanations.push_back(std::move(field));
  if (row.rank_a > 0)
    of_explanations.insert(of_explanations.end(), {std::to_string(row.rank_a), std::to_string(row.rank_b)});
  return line("timing", pair, row.inputs, of_results, of_explanations);
}

/// The timings that all bundles have in common; a bundle that has none in common with the first is not counted.
std::set<Inputs> common_timings(const std::vector<Pair>& pairs) {
  std::optional<std::set<Inputs>> common;
  for (const auto& pair : pairs) {
    const auto here = timed_methods(pair.timing);
    if (here.empty()) continue;
    if (!common) common = here;
    std::erase_if(*common, [&](const Inputs& inputs) { return !here.contains(inputs); });
  }
  return common.value_or(std::set<Inputs>{});
}

}  // namespace

Pair compare_pair(const Side& a, const Side& b) {
  return {a.name, b.name, fact_differences(a, b), same_machine(a, b), compare_accuracy(a, b), compare_timing(a, b)};
}

void rank_in_all(std::vector<Pair>& pairs) {
  const auto common = common_timings(pairs);
  for (auto& pair : pairs) rank(pair.timing, common);
}

std::vector<Standing> standings(const Side& base, const std::vector<Side>& others, const std::vector<Pair>& pairs) {
  const auto common = common_timings(pairs);
  std::vector<Standing> all;
  const auto add = [&](const Side& side) -> Standing& {
    Standing one;
    one.bundle = side.name;
    one.cpu = side.fact("cpu.model_name");
    one.compiler = side.fact("build.compiler");
    return all.emplace_back(std::move(one));
  };
  auto& first = add(base);
  first.timings = common.size();
  if (!common.empty()) first.mean_ratio = first.mean_normalised = 1;
  for (std::size_t k = 0; k < others.size(); ++k) {
    auto& one = add(others[k]);
    one.same_machine = pairs[k].same_machine;
    one.differing = pairs[k].accuracy.differing();
    double logarithms = 0;
    double normalised = 0;
    for (const auto& row : pairs[k].timing.rows) {
      if (!common.contains(row.inputs)) continue;
      ++one.timings;
      logarithms += std::log(row.raw.ratio.median);
      normalised += row.normalised ? std::log(row.normalised->ratio.median) : std::numeric_limits<double>::quiet_NaN();
    }
    if (one.timings == 0) continue;
    one.mean_ratio = std::exp(logarithms / static_cast<double>(one.timings));
    one.mean_normalised = std::exp(normalised / static_cast<double>(one.timings));
  }
  const auto ratio_or_last = [](const Standing& one) {
    return one.timings > 0 ? one.mean_ratio : std::numeric_limits<double>::infinity();
  };
  std::ranges::stable_sort(all, {}, ratio_or_last);
  for (auto& one : all)
    if (one.timings > 0)
      one.rank = 1 + std::ranges::count_if(
                         all, [&](const Standing& rival) { return ratio_or_last(rival) < ratio_or_last(one); });
  return all;
}

bundle::CsvTable comparison_table(const std::vector<Pair>& pairs) {
  Fields columns{"kind"};
  columns.insert(columns.end(), leading_inputs.begin(), leading_inputs.end());
  columns.insert(columns.end(), results.begin(), results.end());
  columns.insert(columns.end(), further_inputs.begin(), further_inputs.end());
  columns.insert(columns.end(), explanations.begin(), explanations.end());
  bundle::CsvTable table(columns);
  for (const auto& pair : pairs) {
    for (const auto& row : pair.accuracy.rows) table.add_row(accuracy_line(pair, row));
    for (const auto& row : pair.timing.rows) table.add_row(timing_line(pair, row));
  }
  return table;
}

bundle::CsvTable facts_table(const std::vector<Pair>& pairs) {
  bundle::CsvTable table({"against", "bundle", "fact", "a", "b"});
  for (const auto& pair : pairs)
    for (const auto& fact : pair.facts) table.add_row({pair.against, pair.bundle, fact.name, fact.a, fact.b});
  return table;
}

bundle::CsvTable standings_table(const std::vector<Standing>& standings) {
  bundle::CsvTable table({"rank", "bundle", "cpu", "compiler", "machine", "accuracy_rows_differing", "timings",
                          "mean_ratio", "mean_normalised"});
  for (const auto& one : standings)
    table.add_row({one.rank ? std::to_string(*one.rank) : "", one.bundle, one.cpu, one.compiler,
                   one.same_machine ? "same" : "other", std::to_string(one.differing), std::to_string(one.timings),
                   number::decimal(one.mean_ratio), number::decimal(one.mean_normalised)});
  return table;
}

}  // namespace bezierbench::compare
