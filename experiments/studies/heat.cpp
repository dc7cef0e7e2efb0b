// SPDX-License-Identifier: MIT
#include "experiments/studies/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/studies/timed_problem.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"
#include "experiments/timing/stack_place.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::string_view no_baseline = "exact";  // what a study has that names none; times are not compared with it

/// Of sittings in which the machine is quiet, but for what memory they met.
constexpr double tolerated_disagreement = 0.05;

/// In the order of timing::sentinels().
std::array<const HeatLap*, 2> sentinels_of(const std::vector<HeatLap>& laps) {
  return {&laps[laps.size() - 2], &laps.back()};
}

/// All against each other and the sentinels; a rival whose results were wrong is not `checked`.
HeatLaps race_of(const Heat& heat, const suite::Study& study, JudgedRivals contestants, std::size_t sitting,
                 const timing::RaceOptions& options) {
  std::ranges::copy(timing::sentinels(), std::back_inserter(contestants.rivals));
  const auto name = fmt::format("{}/{}/{}", study.id, heat.cell.degree, suite::name(heat.mode));
  auto laps = timing::with_stack_moved(sitting, [&] { return timing::race(name, contestants.rivals, options); });
  for (std::size_t m = 0; m < contestants.right.size(); ++m) laps[m].checked = laps[m].checked && contestants.right[m];
  HeatLaps result;
  for (auto& lap : laps) result.each.push_back({{std::move(lap)}});
  return result;
}

}  // namespace

std::vector<Heat> heats_of(const suite::Study& study) { return timed_problem(study).heats(study); }

timing::Lap HeatLap::rounds() const {
  timing::Lap all;
  for (const auto& sitting : sittings) all.append(sitting);
  return all;
}

std::vector<double> HeatLap::sitting_ns() const {
  std::vector<double> medians;
  for (const auto& sitting : sittings) medians.push_back(timing::median_ns(sitting));
  return medians;
}

void HeatLaps::merge(const HeatLaps& other) {
  if (each.empty()) each.resize(other.each.size());
  if (other.each.size() != each.size()) throw std::invalid_argument("sittings of different heats");
  for (std::size_t m = 0; m < each.size(); ++m) {
    const auto& more = other.each[m].sittings;
    each[m].sittings.insert(each[m].sittings.end(), more.begin(), more.end());
  }
}

HeatLaps run(const Heat& heat, const suite::Study& study, std::uint64_t seed, std::size_t sitting,
             const timing::RaceOptions& options) {
  return race_of(heat, study, timed_problem(study).rivals(heat, study, seed), sitting, options);
}

void Pace::speed_up(const Pace& other) {
  chain_ns = std::min(chain_ns, other.chain_ns);
  sweep_ns = std::min(sweep_ns, other.sweep_ns);
}

double Pace::over(const Pace& other) const { return std::max(chain_ns / other.chain_ns, sweep_ns / other.sweep_ns); }

Pace pace(const std::vector<HeatLap>& laps) {
  const auto [sweep, chain] = sentinels_of(laps);
  return {metric::median(chain->sitting_ns()), metric::median(sweep->sitting_ns())};
}

Pace fastest_pace(const std::vector<HeatLap>& laps) {
  if (laps.empty()) return {};
  const auto [sweep, chain] = sentinels_of(laps);
  return {std::ranges::min(chain->sitting_ns()), std::ranges::min(sweep->sitting_ns())};
}

Pace fastest_pace(const std::vector<Heat>& heats) {
  Pace fastest;
  for (const auto& heat : heats) fastest.speed_up(fastest_pace(heat.laps));
  return fastest;
}

bool drifted(const std::vector<HeatLap>& laps, const Pace& fastest) {
  return pace(laps).over(fastest) > 1 + metric::tolerated_drift;
}

bool sittings_disagree(const HeatLap& lap) {
  constexpr double quarter = 0.25;
  const auto ns = lap.sitting_ns();
  return metric::quantile(ns, 1 - quarter) > (1 + tolerated_disagreement) * metric::quantile(ns, quarter);
}

std::string named_baseline(const suite::Study& study) {
  const auto named = std::ranges::find_if(study.baseline, [](const auto& id) { return id != no_baseline; });
  return named == study.baseline.end() ? "" : *named;
}

std::optional<std::size_t> relative_to(const Heat& heat, const suite::Study& study) {
  const auto first_that_matches = [&](std::string_view pattern) -> std::optional<std::size_t> {
    for (std::size_t m = 0; m < heat.methods.size(); ++m)
      if (suite::means(pattern, heat.methods[m]->id)) return m;
    return std::nullopt;
  };
  if (const auto named = named_baseline(study); !named.empty()) return first_that_matches(named);
  for (const auto& pattern : study.methods)
    if (const auto first = first_that_matches(pattern)) return first;
  return first_that_matches("*");
}

}  // namespace bezierbench::studies
