// SPDX-License-Identifier: MIT
#include "experiments/compare/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "experiments/compare/ratio.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::compare {
namespace {

constexpr std::string_view few_rounds = "few_rounds";
constexpr std::string_view unchecked = "unchecked";
constexpr std::string_view noisy = "noisy";
constexpr std::array<std::string_view, 4> qualities{quality_ok, noisy, few_rounds, unchecked};  // best first

double time(const bundle::CsvDocument& table, std::size_t row, std::string_view column) {
  const auto value = number::parse_number(table.at(row, column));
  if (!value)
    throw Failure(Exit::input_output, fmt::format("{}:{}: {} is not a number; restore the file or run the suite again",
                                                  table.file_name(), table.line(row), column));
  return *value;
}

metric::Interval interval(const bundle::CsvDocument& table, std::size_t row) {
  return {time(table, row, "median_ns"), time(table, row, "low_ns"), time(table, row, "high_ns")};
}

/// The time in units of the sentinel of the same races. Empty in the sentinel's own row and in bundles of earlier
/// versions.
std::optional<metric::Interval> units(const bundle::CsvDocument& table, std::size_t row) {
  if (!table.has_column("sentinel_units") || table.at(row, "sentinel_units").empty()) return std::nullopt;
  return metric::Interval{time(table, row, "sentinel_units"), time(table, row, "sentinel_units_low"),
                          time(table, row, "sentinel_units_high")};
}

std::string_view quality(const bundle::CsvDocument& table, std::size_t row) {
  if (table.has_column("checked") && table.at(row, "checked") != "yes") return unchecked;
  return table.has_column("quality") ? std::string_view(table.at(row, "quality")) : quality_ok;
}

/// The worse of two qualities. One that this program does not know is worse than every known one.
std::string worse(std::string_view a, std::string_view b) {
  return std::string(std::ranges::find(qualities, a) > std::ranges::find(qualities, b) ? a : b);
}

/// Whether the times of fixed work (sentinel or sweep) beside these two rows differ by more than the tolerated drift.
/// On the same machine with the same build this means that the machine was disturbed or ran at another speed, so that a
/// difference between the rows says nothing about the methods.
bool machine_changed(const bundle::CsvDocument& ours, const bundle::CsvDocument& theirs, const RowPair& pair) {
  const auto differs = [&](std::string_view column) {
    const auto has = [column](const bundle::CsvDocument& table, std::size_t row) {
      return table.has_column(column) && !table.at(row, column).empty();
    };
    if (!has(ours, pair.a) || !has(theirs, pair.b)) return false;
    const double a = time(ours, pair.a, column);
    const double b = time(theirs, pair.b, column);
    return std::max(a, b) > (1 + metric::tolerated_drift) * std::min(a, b);
  };
  return differs("sentinel_ns") || differs("sweep_ns");
}

/// Whether the sentinels of both sides are the same machine code on the same machine: another compiler or other flags
/// may make a sentinel faster or slower.
bool same_sentinels(const Side& a, const Side& b) {
  return same_machine(a, b) && a.fact("build.compiler") == b.fact("build.compiler") &&
         a.fact("build.flags") == b.fact("build.flags");
}

TimeRatio judged(const metric::Interval& ratio, std::string_view quality) {
  return {ratio, quality == few_rounds ? metric::Verdict::unresolved : metric::verdict(ratio)};
}

/// The key by which the sentinel's row of a race is found. It has no degree, since a sentinel's row has none.
struct Race {
  std::string study;
  std::string curve;
  std::string mode;
  friend auto operator<=>(const Race&, const Race&) = default;
};

Race race_of(const Inputs& inputs) { return {inputs.field("study"), inputs.field("curve"), inputs.field("mode")}; }

/// Fills in the times in units of the sentinel for bundles that do not record them: the unit is the sentinel's time
/// over all races of the study in the same mode.
void normalise(std::vector<TimingRow>& rows) {
  std::map<Race, const TimingRow*> sentinels;
  for (const auto& row : rows)
    if (row.is_sentinel()) sentinels.emplace(race_of(row.inputs), &row);
  for (auto& row : rows) {
    const auto found = sentinels.find(race_of(row.inputs));
    if (row.is_sentinel() || row.normalised || found == sentinels.end()) continue;
    row.normalised = judged(ratio_in_units(row.b, found->second->b, row.a, found->second->a), row.quality);
  }
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
  TimingComparison comparison;
  const auto* ours = a.table(timing_file);
  const auto* theirs = b.table(timing_file);
  if (ours == nullptr || theirs == nullptr) {
    comparison.only_a = ours == nullptr ? 0 : ours->row_count();
    comparison.only_b = theirs == nullptr ? 0 : theirs->row_count();
    return comparison;
  }
  const bool fixed_work_compares = same_sentinels(a, b);
  auto match = match_rows(*bundle::declared_table(timing_file), *ours, *theirs);
  for (auto& pair : match.pairs) {
    const auto time_a = interval(*ours, pair.a);
    const auto time_b = interval(*theirs, pair.b);
    auto doubt = worse(quality(*ours, pair.a), quality(*theirs, pair.b));
    if (fixed_work_compares && machine_changed(*ours, *theirs, pair)) doubt = worse(doubt, noisy);
    const auto units_a = units(*ours, pair.a);
    const auto units_b = units(*theirs, pair.b);
    comparison.rows.push_back(
        {.inputs = std::move(pair.inputs),
         .a = time_a,
         .b = time_b,
         .raw = judged(ratio(time_b, time_a), doubt),
         .normalised = units_a && units_b ? std::optional(judged(ratio(*units_b, *units_a), doubt)) : std::nullopt,
         .quality = doubt});
  }
  comparison.only_a = match.only_a;
  comparison.only_b = match.only_b;
  normalise(comparison.rows);
  rank(comparison, timed_methods(comparison));
  return comparison;
}

}  // namespace bezierbench::compare
