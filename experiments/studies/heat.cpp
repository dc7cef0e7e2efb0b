// SPDX-License-Identifier: MIT
#include "experiments/studies/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/timed_check.hpp"
#include "experiments/studies/timed_inputs.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"
#include "experiments/timing/kernel_rival.hpp"

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

template <class Scalar>
std::vector<timing::Lap> race_of(const Heat& heat, const suite::Study& study, std::uint64_t seed,
                                 const timing::RaceOptions& options) {
  const auto inputs = timed_inputs<Scalar>(study, heat.cell, seed);
  std::vector<timing::Rival> rivals;
  std::vector<bool> right;
  for (const auto* info : heat.methods) {
    const auto& kernel = *find_method<Scalar>(info->id, info->form, heat.cell.dimension);
    auto judged = judge(kernel, heat.mode, inputs);
    right.push_back(judged.right);
    rivals.push_back(timing::kernel_rival(kernel, heat.mode, inputs, std::move(judged.points)));
  }
  rivals.push_back(timing::sentinel());
  auto laps =
      timing::race(fmt::format("{}/{}/{}", study.id, heat.cell.degree, suite::name(heat.mode)), rivals, options);
  for (std::size_t m = 0; m < right.size(); ++m) laps[m].checked = laps[m].checked && right[m];
  return laps;
}

}  // namespace

std::vector<Heat> heats_of(const suite::Study& study) {
  std::vector<Heat> heats;
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      for (const auto mode : study.modes)
        heats.push_back(
            {cell, scalar, mode,
             scalar == suite::ScalarKind::float32 ? methods_of<float>(study, cell) : methods_of<double>(study, cell)});
  return heats;
}

std::vector<timing::Lap> run(const Heat& heat, const suite::Study& study, std::uint64_t seed,
                             const timing::RaceOptions& options) {
  return heat.scalar == suite::ScalarKind::float32 ? race_of<float>(heat, study, seed, options)
                                                   : race_of<double>(heat, study, seed, options);
}

timing::HalfMedians sentinel_of(const std::vector<timing::Lap>& laps) {
  return timing::half_medians(laps.back().ns_per_point);
}

double fastest_sentinel(const std::vector<Heat>& heats) {
  double fastest = std::numeric_limits<double>::infinity();
  for (const auto& heat : heats)
    if (!heat.laps.empty()) fastest = std::min(fastest, sentinel_of(heat.laps).fast);
  return fastest;
}

bool drifted(const std::vector<timing::Lap>& laps, double fastest) {
  return timing::drift(sentinel_of(laps), fastest) > timing::tolerated_drift;
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
