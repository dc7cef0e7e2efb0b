// SPDX-License-Identifier: MIT
#include "experiments/studies/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/studies/companion_rivals.hpp"
#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/timed_check.hpp"
#include "experiments/studies/timed_inputs.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"
#include "experiments/timing/kernel_rival.hpp"
#include "experiments/timing/stack_place.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::string_view no_baseline = "exact";  // what a study has that names none; times are not compared with it

template <class Scalar>
std::vector<const MethodInfo*> methods_of(const suite::Study& study, const sample::Cell& cell) {
  std::vector<const MethodInfo*> methods;
  for (const auto* kernel : chosen_kernels<Scalar>(study, cell.dimension))
    if (kernel->info->template supports<Scalar>(cell.degree)) methods.push_back(kernel->info);
  return methods;
}

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

template <class Scalar>
HeatLaps race_of_evaluators(const Heat& heat, const suite::Study& study, std::uint64_t seed, std::size_t sitting,
                            const timing::RaceOptions& options) {
  const auto inputs = timed_inputs<Scalar>(study, heat.cell, seed);
  JudgedRivals contestants;
  for (const auto* info : heat.methods) {
    const auto& kernel = *find_method<Scalar>(info->id, info->form, heat.cell.dimension);
    auto judged = judge(kernel, heat.mode, inputs);
    contestants.right.push_back(judged.right);
    contestants.rivals.push_back(timing::kernel_rival(kernel, heat.mode, inputs, std::move(judged.points)));
  }
  return race_of(heat, study, std::move(contestants), sitting, options);
}

}  // namespace

std::vector<Heat> heats_of(const suite::Study& study) {
  std::vector<Heat> heats;
  if (const Problem problem = timed_problem(study); problem != Problem::evaluation) {
    for (const auto& cell : sample::cells(study))
      heats.push_back(
          {cell, suite::ScalarKind::float64, suite::Mode::one_shot, timed_companions(study, problem, cell), problem});
    return heats;
  }
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      for (const auto mode : study.modes)
        heats.push_back(
            {cell, scalar, mode,
             scalar == suite::ScalarKind::float32 ? methods_of<float>(study, cell) : methods_of<double>(study, cell)});
  return heats;
}

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
  if (heat.problem != Problem::evaluation)
    return race_of(heat, study, companion_rivals(heat.methods, heat.problem, study, heat.cell, seed), sitting, options);
  return heat.scalar == suite::ScalarKind::float32 ? race_of_evaluators<float>(heat, study, seed, sitting, options)
                                                   : race_of_evaluators<double>(heat, study, seed, sitting, options);
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
