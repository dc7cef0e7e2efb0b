// SPDX-License-Identifier: MIT
#include "experiments/studies/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

/// All against each other and a sentinel; a rival whose results were wrong is not `checked`.
HeatLaps race_of(const Heat& heat, const suite::Study& study, JudgedRivals contestants, std::size_t sitting,
                 const timing::RaceOptions& options) {
  contestants.rivals.push_back(timing::sentinel());
  const auto name = fmt::format("{}/{}/{}", study.id, heat.cell.degree, suite::name(heat.mode));
  auto laps = timing::with_stack_moved(sitting, [&] { return timing::race(name, contestants.rivals, options); });
  for (std::size_t m = 0; m < contestants.right.size(); ++m) laps[m].checked = laps[m].checked && contestants.right[m];
  HeatLaps result;
  for (auto& lap : laps) {
    const double median = metric::median_interval(lap.ns_per_point, metric::timing_confidence).median;
    result.each.push_back({std::move(lap), {median}});
  }
  return result;
}

}  // namespace

std::vector<Heat> heats_of(const suite::Study& study) { return timed_problem(study).heats(study); }

void HeatLaps::merge(const HeatLaps& other) {
  if (each.empty()) each.resize(other.each.size());
  if (other.each.size() != each.size()) throw std::invalid_argument("sittings of different heats");
  for (std::size_t m = 0; m < each.size(); ++m) {
    each[m].rounds.append(other.each[m].rounds);
    each[m].sitting_ns.insert(each[m].sitting_ns.end(), other.each[m].sitting_ns.begin(),
                              other.each[m].sitting_ns.end());
  }
}

HeatLaps run(const Heat& heat, const suite::Study& study, std::uint64_t seed, std::size_t sitting,
             const timing::RaceOptions& options) {
  return race_of(heat, study, timed_problem(study).rivals(heat, study, seed), sitting, options);
}

double fastest_sentinel(const std::vector<HeatLap>& laps) {
  return laps.empty() ? std::numeric_limits<double>::infinity() : std::ranges::min(laps.back().sitting_ns);
}

double fastest_sentinel(const std::vector<Heat>& heats) {
  double fastest = std::numeric_limits<double>::infinity();
  for (const auto& heat : heats) fastest = std::min(fastest, fastest_sentinel(heat.laps));
  return fastest;
}

bool drifted(const std::vector<HeatLap>& laps, double fastest) {
  const auto sentinel = metric::median_interval(laps.back().sitting_ns, metric::timing_confidence);
  return sentinel.median > (1 + timing::tolerated_drift) * fastest;
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
