// SPDX-License-Identifier: MIT
#include "experiments/compare/gates.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bezierbench::compare {
namespace {

constexpr double percent = 100;

Ruled ruling_on_time(const Row& row, double threshold) {
  const auto& timed = *row.timed;
  if (timed.quality != "ok") return {&row, Ruling::undecided, timed.quality};
  const auto words = fmt::format("{:.3f} [{:.3f}, {:.3f}]", timed.judged.median, timed.judged.low, timed.judged.high);
  if (timed.judged.low > 1 + threshold) return {&row, Ruling::fails, words};
  if (timed.judged.high <= 1 + threshold) return {&row, Ruling::passes, ""};
  return {&row, Ruling::undecided, words};
}

/// The largest of a thousand errors may be half as large again as that of an equally accurate method.
constexpr double beyond_chance = 2;

Ruled ruling_on_errors(const Row& row, double threshold) {
  if (!row.broken.empty()) return {&row, Ruling::fails, row.broken};
  const auto is_mean = [](const auto& error) { return error.first.starts_with("mean"); };
  const bool has_mean = std::ranges::any_of(row.errors, is_mean);
  const bool mean_grew = std::ranges::any_of(row.errors, [&](const auto& e) { return is_mean(e) && e.second > 1; });
  for (const auto& error : row.errors) {
    const auto& [column, growth] = error;
    if (!(growth > 1 + threshold)) continue;
    if (is_mean(error) || !has_mean || mean_grew || growth > beyond_chance)
      return {&row, Ruling::fails, fmt::format("{} is {:.4g} times as large", column, growth)};
  }
  return {&row, Ruling::passes, ""};
}

Ruled ruling_on_cost(const Row& row, double threshold) {
  if (row.ratio.median <= 1 + threshold) return {&row, Ruling::passes, ""};
  return {&row, Ruling::fails, fmt::format("{} instead of {} instructions", row.b, row.a)};
}

Ruled ruling_on_bits(const Row& row) {
  if (row.verdict == identical) return {&row, Ruling::passes, ""};
  return {&row, Ruling::fails, fmt::format("{} {} -> {}", row.column, row.a, row.b)};
}

/// What failing rows are, after their number.
std::string_view what_fails(Gate gate) {
  switch (gate) {
    case Gate::slower: return "times are slower";
    case Gate::less_accurate: return "rows are less accurate";
    case Gate::costlier: return "counts of instructions are larger";
    case Gate::any_change: break;
  }
  return "";
}

}  // namespace

std::string_view name(Gate gate) {
  switch (gate) {
    case Gate::any_change: return "different";
    case Gate::slower: return "slower";
    case Gate::less_accurate: return "less-accurate";
    case Gate::costlier: return "costlier";
  }
  return "";
}

const std::vector<Gate>& gates() {
  static const std::vector<Gate> all{Gate::any_change, Gate::less_accurate, Gate::costlier, Gate::slower};
  return all;
}

std::string_view name(Ruling ruling) {
  switch (ruling) {
    case Ruling::passes: return "passes";
    case Ruling::fails: return "fails";
    case Ruling::undecided: return "undecided";
  }
  return "";
}

std::size_t GateReport::count(Ruling ruling) const {
  return static_cast<std::size_t>(std::ranges::count(rows, ruling, &Ruled::ruling));
}

std::string GateReport::brief() const {
  const auto fails = count(Ruling::fails);
  if (fails == 0) return "";
  if (gate == Gate::any_change) return fmt::format("accuracy differs in {} of {} rows", fails, rows.size());
  const auto text =
      fmt::format("{} of {} {} by more than {:.4g} %", fails, rows.size(), what_fails(gate), percent * threshold);
  const auto undecided = count(Ruling::undecided);
  return undecided == 0 ? text : fmt::format("{}; {} more undecided", text, undecided);
}

std::string GateReport::finding() const {
  const auto found = brief();
  return found.empty() ? ""
                       : fmt::format("{}, against {}: {}; see --all", comparison->b->name, comparison->a->name, found);
}

GateReport rule(Gate gate, const Comparison& comparison, double threshold) {
  GateReport report{gate, &comparison, threshold, {}};
  switch (gate) {
    case Gate::any_change:
      for (const auto& row : comparison.results) report.rows.push_back(ruling_on_bits(row));
      break;
    case Gate::slower:
      for (const auto& row : comparison.times)
        if (!row.is_sentinel()) report.rows.push_back(ruling_on_time(row, threshold));
      break;
    case Gate::less_accurate:
      for (const auto& row : comparison.results) report.rows.push_back(ruling_on_errors(row, threshold));
      break;
    case Gate::costlier:
      for (const auto& row : comparison.costs) report.rows.push_back(ruling_on_cost(row, threshold));
      break;
  }
  return report;
}

}  // namespace bezierbench::compare
