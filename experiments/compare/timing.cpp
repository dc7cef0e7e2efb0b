// SPDX-License-Identifier: MIT
#include "experiments/compare/timing.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "experiments/compare/ratio.hpp"
#include "experiments/tables/table_row.hpp"

namespace bezierbench::compare {
namespace {

constexpr std::array<std::string_view, 4> qualities{"ok", "noisy", "few_rounds", "unchecked"};  // best first

/// The time in units of the sentinel of the same races; empty in the sentinel's own row.
std::optional<metric::Interval> units(const tables::TableRow& row) {
  if (!row.optional_number("sentinel_units")) return std::nullopt;
  return metric::Interval{row.number("sentinel_units"), row.number("sentinel_units_low"),
                          row.number("sentinel_units_high")};
}

metric::Interval time(const tables::TableRow& row) {
  return {row.number("median_ns"), row.number("low_ns"), row.number("high_ns")};
}

std::string_view quality(const tables::TableRow& row) {
  return row.text("checked") == "yes" ? std::string_view(row.text("quality")) : "unchecked";
}

/// The worse of two qualities. One that this program does not know is worse than every known one.
std::string worse(std::string_view a, std::string_view b) {
  return std::string(std::ranges::find(qualities, a) > std::ranges::find(qualities, b) ? a : b);
}

/// Whether the times of fixed work (sentinel or sweep) beside these two rows differ by more than the tolerated drift.
/// On the same machine with the same build this means that the machine was disturbed or ran at another speed, so that a
/// difference between the rows says nothing about the methods.
bool machine_changed(const tables::TableRow& ours, const tables::TableRow& theirs) {
  return std::ranges::any_of(std::array{"sentinel_ns", "sweep_ns"}, [&](std::string_view column) {
    const auto a = ours.optional_number(column);
    const auto b = theirs.optional_number(column);
    return a && b && std::max(*a, *b) > (1 + metric::tolerated_drift) * std::min(*a, *b);
  });
}

/// Whether the sentinels of both sides are the same machine code on the same machine: another compiler or other flags
/// may make a sentinel faster or slower.
bool same_sentinels(const Side& a, const Side& b) {
  return same_machine(a, b) && a.fact("build.compiler") == b.fact("build.compiler") &&
         a.fact("build.flags") == b.fact("build.flags");
}

TimeRatio judged(const metric::Interval& ratio, std::string_view quality) {
  return {ratio, quality == "few_rounds" ? metric::Verdict::unresolved : metric::verdict(ratio)};
}

/// Whether one side resolves x as the faster and the other side y.
bool changed_places(const TimingRow& x, const TimingRow& y) {
  using metric::Verdict;
  const auto in_a = metric::verdict(ratio(x.a, y.a));
  const auto in_b = metric::verdict(ratio(x.b, y.b));
  return (in_a == Verdict::faster && in_b == Verdict::slower) || (in_a == Verdict::slower && in_b == Verdict::faster);
}

}  // namespace

std::set<Inputs> timed_methods(const TimingComparison& timing) {
  std::set<Inputs> methods;
  for (const auto& row : timing.rows)
    if (!row.is_sentinel()) methods.insert(row.inputs);
  return methods;
}

void rank(TimingComparison& timing, const std::set<Inputs>& counted) {
  std::map<Inputs, std::vector<TimingRow*>> races;
  for (auto& row : timing.rows) {
    row.rank_a = row.rank_b = 0;
    row.changed_place = false;
    if (!row.is_sentinel() && counted.contains(row.inputs)) races[row.inputs.without_method()].push_back(&row);
  }
  for (const auto& [inputs, rivals] : races)
    for (auto* row : rivals) {
      const auto faster_in = [row](metric::Interval TimingRow::*side) {
        return [row, side](const TimingRow* rival) { return (rival->*side).high < (row->*side).low; };
      };
      row->rank_a = 1 + static_cast<int>(std::ranges::count_if(rivals, faster_in(&TimingRow::a)));
      row->rank_b = 1 + static_cast<int>(std::ranges::count_if(rivals, faster_in(&TimingRow::b)));
      row->changed_place =
          std::ranges::any_of(rivals, [row](const TimingRow* rival) { return changed_places(*row, *rival); });
    }
}

bool TimingRow::is_certainly_slower() const {
  const auto slower = [](const TimeRatio& of) { return of.verdict == metric::Verdict::slower; };
  return is_ok() && slower(raw) && b.low > a.high && (!normalised || slower(*normalised));
}

TimingComparison compare_timing(const Side& a, const Side& b) {
  const auto* ours = a.table(timing_file);
  const auto* theirs = b.table(timing_file);
  if (ours == nullptr || theirs == nullptr)
    return {{}, ours == nullptr ? 0 : ours->row_count(), theirs == nullptr ? 0 : theirs->row_count()};
  const bool fixed_work_compares = same_sentinels(a, b);
  const auto match = match_rows(*bundle::declared_table(timing_file), *ours, *theirs);
  TimingComparison comparison{{}, match.only_a.size(), match.only_b.size()};
  for (const auto& pair : match.pairs) {
    const tables::TableRow row_a(*ours, pair.a);
    const tables::TableRow row_b(*theirs, pair.b);
    auto doubt = worse(quality(row_a), quality(row_b));
    if (fixed_work_compares && machine_changed(row_a, row_b)) doubt = worse(doubt, "noisy");
    TimingRow row{
        .inputs = pair.inputs, .a = time(row_a), .b = time(row_b), .raw = {}, .normalised = {}, .quality = doubt};
    row.raw = judged(ratio(row.b, row.a), doubt);
    if (const auto units_a = units(row_a), units_b = units(row_b); units_a && units_b)
      row.normalised = judged(ratio(*units_b, *units_a), doubt);
    comparison.rows.push_back(std::move(row));
  }
  rank(comparison, timed_methods(comparison));
  return comparison;
}

}  // namespace bezierbench::compare
