// SPDX-License-Identifier: MIT
#include "experiments/race/race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {
namespace {

constexpr std::string_view no_baseline = "exact";  // of a study that names none; times are not compared with it

/// In the order of sentinels().
std::array<const RivalTimes*, 2> sentinels_of(const std::vector<RivalTimes>& times) {
  return {&times[times.size() - 2], &times.back()};
}

}  // namespace

RaceOptions repetition_options() {
  RaceOptions options;
  options.rounds /= repetitions_per_race;
  options.min_rounds = (options.min_rounds + repetitions_per_race - 1) / repetitions_per_race;
  options.rival_seconds /= repetitions_per_race;
  options.max_seconds /= repetitions_per_race;
  return options;
}

double median_ns(const RoundTimes& repetition) { return metric::median(repetition.ns_per_point); }

double median_ratio(const RoundTimes& repetition, const RoundTimes& base) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < repetition.ns_per_point.size(); ++round)
    ratios.push_back(repetition.ns_per_point[round] / base.ns_per_point[round]);
  return metric::median(ratios);
}

std::vector<double> repetition_ratios(std::span<const RoundTimes> repetitions, std::span<const RoundTimes> base) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < repetitions.size(); ++k) ratios.push_back(median_ratio(repetitions[k], base[k]));
  return ratios;
}

RaceTimes run_rivals(const Race& race, const suite::Study& study, JudgedRivals judged, std::size_t repetition,
                     const RaceOptions& options) {
  if (judged.call) judged.rivals.push_back(*judged.call);
  std::ranges::copy(sentinels(), std::back_inserter(judged.rivals));
  const auto name = fmt::format("{}/{}/{}", study.id, race.cell.degree, suite::name(race.mode));
  auto times = with_stack_moved(repetition, [&] { return time_rounds(name, judged.rivals, options); });
  RaceTimes result;
  for (auto& rounds : times) result.each.push_back({{std::move(rounds)}});
  for (std::size_t m = 0; m < judged.judged.size(); ++m) {
    auto& rival = result.each[m];
    rival.repetitions.front().checked = rival.repetitions.front().checked && judged.judged[m].right;
    rival.max_error_u = judged.judged[m].max_error_u;
  }
  if (judged.call)
    result.operations.push_back(judge::with_scalar(
        race.scalar, [&]<class Scalar>(Scalar /*zero*/) { return measured_operations<Scalar>(options.clock); }));
  return result;
}

RoundTimes RivalTimes::rounds() const {
  RoundTimes all;
  for (const auto& repetition : repetitions) all.append(repetition);
  return all;
}

std::vector<double> RivalTimes::repetition_ns() const {
  std::vector<double> medians;
  for (const auto& repetition : repetitions) medians.push_back(median_ns(repetition));
  return medians;
}

void RaceTimes::merge(const RaceTimes& other) {
  if (!other.counts.empty()) counts = other.counts;
  if (other.each.empty()) return;
  if (each.empty()) each.resize(other.each.size());
  if (other.each.size() != each.size()) throw std::invalid_argument("repetitions of different races");
  for (std::size_t m = 0; m < each.size(); ++m) {
    const auto& more = other.each[m].repetitions;
    each[m].repetitions.insert(each[m].repetitions.end(), more.begin(), more.end());
    if (const auto seen = other.each[m].max_error_u)
      each[m].max_error_u = std::max(each[m].max_error_u.value_or(0), *seen);
  }
  operations.insert(operations.end(), other.operations.begin(), other.operations.end());
}

const RivalTimes* call_times(const Race& race) {
  constexpr std::size_t call_and_sentinels = 3;
  const std::size_t methods = race.methods.size();
  return race.times.size() == methods + call_and_sentinels ? &race.times[methods] : nullptr;
}

double SentinelTimes::over(const SentinelTimes& other) const {
  return std::max(chain_ns / other.chain_ns, sweep_ns / other.sweep_ns);
}

SentinelTimes min(const SentinelTimes& a, const SentinelTimes& b) {
  return {std::min(a.chain_ns, b.chain_ns), std::min(a.sweep_ns, b.sweep_ns)};
}

SentinelTimes median_sentinels(const std::vector<RivalTimes>& times) {
  const auto [sweep, chain] = sentinels_of(times);
  return {metric::median(chain->repetition_ns()), metric::median(sweep->repetition_ns())};
}

SentinelTimes fastest_sentinels(const std::vector<RivalTimes>& times) {
  if (times.empty()) return {};
  const auto [sweep, chain] = sentinels_of(times);
  return {std::ranges::min(chain->repetition_ns()), std::ranges::min(sweep->repetition_ns())};
}

bool drifted(const std::vector<RivalTimes>& times, const SentinelTimes& fastest) {
  return median_sentinels(times).over(fastest) > 1 + metric::tolerated_drift;
}

std::string named_baseline(const suite::Study& study) {
  const auto named = std::ranges::find_if(study.baseline, [](const auto& id) { return id != no_baseline; });
  return named == study.baseline.end() ? "" : *named;
}

std::optional<std::size_t> relative_to(const Race& race, const suite::Study& study) {
  const auto first_that_matches = [&](std::string_view pattern) -> std::optional<std::size_t> {
    for (std::size_t m = 0; m < race.methods.size(); ++m)
      if (suite::means(pattern, race.methods[m]->id)) return m;
    return std::nullopt;
  };
  if (const auto named = named_baseline(study); !named.empty()) return first_that_matches(named);
  for (const auto& pattern : study.methods)
    if (const auto first = first_that_matches(pattern)) return first;
  return first_that_matches("*");
}

}  // namespace bezierbench::race
