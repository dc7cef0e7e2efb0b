// SPDX-License-Identifier: MIT
#include "experiments/race/race_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/race/repetition.hpp"
#include "experiments/race/timed_problem.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::race {
namespace {

constexpr std::string_view no_baseline = "exact";  // of a study that names none; times are not compared with it

/// The spread of repetitions on a quiet machine, which only differ in where memory lies.
constexpr double tolerated_disagreement = 0.05;

/// In the order of sentinels().
std::array<const RaceCellLap*, 2> sentinels_of(const std::vector<RaceCellLap>& laps) {
  return {&laps[laps.size() - 2], &laps.back()};
}

}  // namespace

RaceCellLaps race_of(const RaceCell& race_cell, const suite::Study& study, JudgedRivals judged, std::size_t repetition,
                     const RaceOptions& options) {
  if (judged.call) judged.rivals.push_back(*judged.call);
  std::ranges::copy(sentinels(), std::back_inserter(judged.rivals));
  const auto name = fmt::format("{}/{}/{}", study.id, race_cell.cell.degree, suite::name(race_cell.mode));
  auto laps = with_stack_moved(repetition, [&] { return race(name, judged.rivals, options); });
  RaceCellLaps result;
  for (auto& lap : laps) result.each.push_back({{std::move(lap)}});
  for (std::size_t m = 0; m < judged.judged.size(); ++m) {
    auto& lap = result.each[m];
    lap.repetitions.front().checked = lap.repetitions.front().checked && judged.judged[m].right;
    lap.max_error_u = judged.judged[m].max_error_u;
  }
  if (judged.call)
    result.operations.push_back(judge::with_scalar(
        race_cell.scalar, [&]<class Scalar>(Scalar /*zero*/) { return measured_operations<Scalar>(options.clock); }));
  return result;
}

Lap RaceCellLap::rounds() const {
  Lap all;
  for (const auto& repetition : repetitions) all.append(repetition);
  return all;
}

std::vector<double> RaceCellLap::repetition_ns() const {
  std::vector<double> medians;
  for (const auto& repetition : repetitions) medians.push_back(median_ns(repetition));
  return medians;
}

void RaceCellLaps::merge(const RaceCellLaps& other) {
  if (each.empty()) each.resize(other.each.size());
  if (other.each.size() != each.size()) throw std::invalid_argument("repetitions of different race cells");
  for (std::size_t m = 0; m < each.size(); ++m) {
    const auto& more = other.each[m].repetitions;
    each[m].repetitions.insert(each[m].repetitions.end(), more.begin(), more.end());
    if (const auto seen = other.each[m].max_error_u)
      each[m].max_error_u = std::max(each[m].max_error_u.value_or(0), *seen);
  }
  operations.insert(operations.end(), other.operations.begin(), other.operations.end());
}

const RaceCellLap* call_of(const RaceCell& race_cell) {
  constexpr std::size_t call_and_sentinels = 3;
  const std::size_t methods = race_cell.methods.size();
  return race_cell.laps.size() == methods + call_and_sentinels ? &race_cell.laps[methods] : nullptr;
}

RaceCellLaps run(const TimedProblem& problem, const RaceCell& race_cell, const suite::Study& study, std::uint64_t seed,
                 std::size_t repetition, const RaceOptions& options, std::shared_ptr<const void>& trials) {
  return race_of(race_cell, study, problem.rivals(race_cell, study, seed, trials), repetition, options);
}

void Pace::speed_up(const Pace& other) {
  chain_ns = std::min(chain_ns, other.chain_ns);
  sweep_ns = std::min(sweep_ns, other.sweep_ns);
}

double Pace::over(const Pace& other) const { return std::max(chain_ns / other.chain_ns, sweep_ns / other.sweep_ns); }

Pace pace(const std::vector<RaceCellLap>& laps) {
  const auto [sweep, chain] = sentinels_of(laps);
  return {metric::median(chain->repetition_ns()), metric::median(sweep->repetition_ns())};
}

Pace fastest_pace(const std::vector<RaceCellLap>& laps) {
  if (laps.empty()) return {};
  const auto [sweep, chain] = sentinels_of(laps);
  return {std::ranges::min(chain->repetition_ns()), std::ranges::min(sweep->repetition_ns())};
}

Pace fastest_pace(const std::vector<RaceCell>& race_cells) {
  Pace fastest;
  for (const auto& race_cell : race_cells) fastest.speed_up(fastest_pace(race_cell.laps));
  return fastest;
}

bool drifted(const std::vector<RaceCellLap>& laps, const Pace& fastest) {
  return pace(laps).over(fastest) > 1 + metric::tolerated_drift;
}

bool repetitions_disagree(const RaceCellLap& lap) {
  constexpr double quarter = 0.25;
  const auto ns = lap.repetition_ns();
  return metric::quantile(ns, 1 - quarter) > (1 + tolerated_disagreement) * metric::quantile(ns, quarter);
}

std::string named_baseline(const suite::Study& study) {
  const auto named = std::ranges::find_if(study.baseline, [](const auto& id) { return id != no_baseline; });
  return named == study.baseline.end() ? "" : *named;
}

std::optional<std::size_t> relative_to(const RaceCell& race_cell, const suite::Study& study) {
  const auto first_that_matches = [&](std::string_view pattern) -> std::optional<std::size_t> {
    for (std::size_t m = 0; m < race_cell.methods.size(); ++m)
      if (suite::means(pattern, race_cell.methods[m]->id)) return m;
    return std::nullopt;
  };
  if (const auto named = named_baseline(study); !named.empty()) return first_that_matches(named);
  for (const auto& pattern : study.methods)
    if (const auto first = first_that_matches(pattern)) return first;
  return first_that_matches("*");
}

}  // namespace bezierbench::race
