// SPDX-License-Identifier: MIT
#include "experiments/studies/roofline/roofline_rows.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/batch/flops.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::string_view scalar_kernel = "scalar";

metric::Interval interval(std::span<const double> sample) {
  return metric::median_interval(sample, metric::timing_confidence);
}

std::vector<std::string> fields(const metric::Interval& values) {
  return {number::decimal(values.median), number::decimal(values.low), number::decimal(values.high)};
}

/// What the row of a contestant is asked to reach.
struct Goal {
  std::optional<double> share;  ///< of the peak, at least
  std::optional<double> ns;     ///< per point, at most
};

/// One race, with what its rows have in common.
class Race {
 public:
  explicit Race(const RooflineRace& race) : race_(race) {}

  [[nodiscard]] const race::Lap* lap(Work work, const batch::Target* target, std::string_view id = {}) const {
    for (std::size_t k = 0; k < race_.contestants.size(); ++k) {
      const auto& who = race_.contestants[k];
      if (who.work == work && who.target == target && (who.method == nullptr || who.method->id == id))
        return &race_.laps[k];
    }
    return nullptr;
  }

  /// Operations per nanosecond.
  [[nodiscard]] double peak(Work work, const batch::Target* target) const {
    return 1 / interval(lap(work, target)->ns_per_point).median;
  }

  /// Of the study's goals those that are about this row.
  [[nodiscard]] Goal goal(const TargetRival& who, const std::vector<suite::Goal>& goals) const {
    Goal case_values;
    for (const auto& one : goals) {
      if (!is_about(one, who)) continue;
      if (one.share > 0) case_values.share = one.share;
      const auto* rival = lap(Work::scalar_points, nullptr, one.no_slower_than);
      if (!one.no_slower_than.empty() && rival != nullptr) case_values.ns = interval(rival->ns_per_point).median;
    }
    return case_values;
  }

 private:
  [[nodiscard]] bool is_about(const suite::Goal& goal, const TargetRival& who) const {
    const int degree = race_.cell.degree;
    if (goal.method != who.method->id || goal.scalar != race_.scalar) return false;
    if (degree < goal.from_degree || degree > goal.to_degree) return false;
    return !goal.needs_additions_beside ||
           peak(Work::multiply_add_and_add, who.target) > peak(Work::multiply_add, who.target);
  }

  const RooflineRace& race_;
};

/// Of what a target can do at most: the share that a lap of a method used.
metric::Interval share(const race::Lap& lap, const race::Lap& peak, double flops) {
  std::vector<double> shares;
  for (std::size_t round = 0; round < lap.ns_per_point.size(); ++round)
    shares.push_back(flops * peak.ns_per_point[round] / lap.ns_per_point[round]);
  return interval(shares);
}

std::string text(const std::optional<double>& value) { return value ? number::decimal(*value) : ""; }

/// The quickest that each target's peak was in any race of a study, in each scalar type: ns per operation.
using Fastest = std::map<std::pair<const batch::Target*, suite::ScalarKind>, double>;

Fastest fastest_peaks(const std::vector<RooflineRace>& races) {
  Fastest fastest;
  for (const auto& race : races)
    for (std::size_t k = 0; k < race.laps.size(); ++k) {
      if (race.contestants[k].work != Work::multiply_add) continue;
      const double ns = interval(race.laps[k].ns_per_point).median;
      const auto [place, is_first] = fastest.try_emplace({race.contestants[k].target, race.scalar}, ns);
      if (!is_first) place->second = std::min(place->second, ns);
    }
  return fastest;
}

void add_row(bundle::CsvTable& table, const suite::Study& study, const RooflineRace& race, std::size_t place,
             const Fastest& fastest) {
  const auto& who = race.contestants[place];
  const auto& lap = race.laps[place];
  const Race all(race);
  const auto ns = interval(lap.ns_per_point);
  const double flops = batch::flops_per_point(*who.evaluator, race.cell.degree, race.cell.dimension);
  std::vector<std::string> row{study.id,
                               std::string(suite::name(study.curve)),
                               std::string(who.method->id),
                               std::string(suite::name(race.scalar)),
                               std::to_string(race.cell.dimension),
                               std::to_string(race.cell.degree),
                               std::string(who.target == nullptr ? scalar_kernel : who.target->name)};
  const auto append = [&](const std::vector<std::string>& more) { row.insert(row.end(), more.begin(), more.end()); };
  append(fields(ns));
  append({number::decimal(flops), number::decimal(flops / ns.median)});
  if (who.target == nullptr) {
    append({"", "", "", "", "", "", "", "", ""});
  } else {
    const auto used = share(lap, *all.lap(Work::multiply_add, who.target), flops);
    const auto goal = all.goal(who, suite::keys_of<suite::RooflineKeys>(study).goals);
    append({number::decimal(all.peak(Work::multiply_add, who.target)),
            number::decimal(all.peak(Work::multiply_add_and_add, who.target))});
    append(fields(used));
    append({text(goal.share), text(goal.ns)});
    const bool met = (!goal.share || used.median >= *goal.share) && (!goal.ns || ns.median <= *goal.ns);
    append({!goal.share && !goal.ns ? "" : met ? "yes" : "no"});
    const double peak_ns = 1 / all.peak(Work::multiply_add, who.target);
    const bool steady = peak_ns <= (1 + metric::tolerated_drift) * fastest.at({who.target, race.scalar});
    append({steady ? "ok" : "noisy"});
  }
  append({std::to_string(lap.ns_per_point.size()), lap.checked ? "yes" : "no"});
  append(tables::drawn_fields(race.cell));
  table.add_row(std::move(row));
}

}  // namespace

void write_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables) {
  std::vector<std::string> columns{
      "study",         "curve",     "method",     "scalar",     "dimension", "degree",      "target",
      "median_ns",     "low_ns",    "high_ns",    "flops",      "gflops",    "peak_gflops", "mixed_peak_gflops",
      "share_of_peak", "share_low", "share_high", "goal_share", "goal_ns",   "goal_met",    "quality",
      "rounds",        "checked"};
  columns.insert(columns.end(), tables::drawn_columns().begin(), tables::drawn_columns().end());
  auto& table = tables.table("roofline.csv", columns);
  const auto fastest = fastest_peaks(races);
  for (const auto& race : races)
    for (std::size_t k = 0; k < race.laps.size(); ++k)
      if (race.contestants[k].method != nullptr) add_row(table, study, race, k, fastest);
}

}  // namespace bezierbench::studies
