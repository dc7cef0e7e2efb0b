// SPDX-License-Identifier: MIT
#include "experiments/compare/comparison.hpp"

#include <array>

#include "experiments/number/number.hpp"

namespace bezierbench::compare {
namespace {

/// The names of inputs as columns of comparison.csv; the first array has those that the contract lists, in its order.
constexpr std::array<std::string_view, 6> leading_inputs{"study", "method", "scalar", "dimension", "degree", "mode"};
constexpr std::array<std::string_view, 8> further_inputs{"table", "curve",     "coordinate_range", "t_min",
                                                         "t_max", "generator", "trials",           "baseline"};

void append(std::vector<std::string>& fields, std::initializer_list<std::string> more) {
  fields.insert(fields.end(), more);
}

template <class Names>
void append_inputs(std::vector<std::string>& fields, const Inputs& inputs, const Names& names) {
  for (const auto name : names) fields.push_back(inputs.field(name));
}

void append_ratio(std::vector<std::string>& fields, const TimeRatio& of) {
  append(fields, {number::decimal(of.ratio.median), number::decimal(of.ratio.low), number::decimal(of.ratio.high),
                  std::string(metric::name(of.verdict))});
}

std::vector<std::string> accuracy_fields(const Pair& pair, const AccuracyRow& row) {
  std::vector<std::string> fields{"accuracy"};
  append_inputs(fields, row.inputs, leading_inputs);
  const auto a = number::parse_number(row.a);
  const auto b = number::parse_number(row.b);
  append(fields, {row.a, row.b, a && b && *a != 0 ? number::decimal(*b / *a) : "", "", "",
                  row.identical ? "identical" : "different"});
  append_inputs(fields, row.inputs, further_inputs);
  append(fields, {pair.against, pair.bundle, row.file, row.column, "", "", "", "", "", "", ""});
  return fields;
}

std::vector<std::string> timing_fields(const Pair& pair, const TimingRow& row) {
  std::vector<std::string> fields{"timing"};
  append_inputs(fields, row.inputs, leading_inputs);
  append(fields, {number::decimal(row.a.median), number::decimal(row.b.median)});
  append_ratio(fields, row.raw);
  append_inputs(fields, row.inputs, further_inputs);
  append(fields, {pair.against, pair.bundle, timing_file, "median_ns", row.quality});
  if (row.normalised)
    append_ratio(fields, *row.normalised);
  else
    append(fields, {"", "", "", ""});
  if (row.rank_a == 0)
    append(fields, {"", ""});
  else
    append(fields, {std::to_string(row.rank_a), std::to_string(row.rank_b)});
  return fields;
}

}  // namespace

Pair compare_pair(const Side& a, const Side& b) {
  return {a.name, b.name, fact_differences(a, b), same_machine(a, b), compare_accuracy(a, b), compare_timing(a, b)};
}

bundle::CsvTable comparison_table(const std::vector<Pair>& pairs) {
  std::vector<std::string> columns{"kind"};
  columns.insert(columns.end(), leading_inputs.begin(), leading_inputs.end());
  append(columns, {"a", "b", "ratio", "ratio_low", "ratio_high", "verdict"});
  columns.insert(columns.end(), further_inputs.begin(), further_inputs.end());
  append(columns, {"against", "bundle", "file", "column", "quality", "normalised", "normalised_low", "normalised_high",
                   "normalised_verdict", "rank_a", "rank_b"});
  bundle::CsvTable table(columns);
  for (const auto& pair : pairs) {
    for (const auto& row : pair.accuracy.rows) table.add_row(accuracy_fields(pair, row));
    for (const auto& row : pair.timing.rows) table.add_row(timing_fields(pair, row));
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
