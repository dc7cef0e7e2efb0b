// SPDX-License-Identifier: MIT
// Does the clockwork tell the truth where it is known? Races a kernel against itself, which must come out `same`, and
// against itself with 103 evaluations charged as 100, which must come out `slower`; prints the counts of verdicts.
#include <fmt/core.h>

#include <map>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/timing/kernel_rival.hpp"
#include "experiments/timing/sentinel.hpp"

namespace {

using namespace bezierbench;

constexpr int races = 100;
constexpr int enough = 95;
constexpr std::size_t charged = 100;
constexpr std::size_t evaluations_if_slower = 103;

timing::Inputs<double> inputs_of(std::size_t count) {
  constexpr int degree = 10;
  timing::Inputs<double> inputs{Form::bernstein, 2, degree, {}, {}, {}};
  std::vector<double> coefficients;
  for (int k = 0; k < 2 * (degree + 1); ++k) coefficients.push_back(k * k % 17 / 17.0 - 0.5);
  inputs.curves.assign(count, coefficients);
  for (std::size_t k = 0; k < count; ++k)
    inputs.t.push_back((static_cast<double>(k * 37 % count) + 0.5) / static_cast<double>(count));
  return inputs;
}

std::vector<double> points_of(const Kernel<double>& kernel, const timing::Inputs<double>& inputs) {
  constexpr std::align_val_t alignment{64};
  const auto release = [](void* memory) { ::operator delete(memory, alignment); };
  const std::unique_ptr<void, decltype(release)> prepared(::operator new(kernel.prepared_size, alignment), release);
  kernel.prepare(inputs.curve(0), prepared.get());
  std::vector<double> points(inputs.t.size() * 2);
  kernel.evaluate(prepared.get(), inputs.t, points.data());
  return points;
}

timing::Rival rival_of(const Kernel<double>& kernel, suite::Mode mode, const timing::Inputs<double>& inputs) {
  auto rival = timing::kernel_rival(kernel, mode, inputs, points_of(kernel, inputs));
  rival.points_per_batch = charged;
  return rival;
}

/// The verdict on the second of two rivals against the first, as a row of timing.csv would say it.
metric::Verdict verdict_of(const Kernel<double>& kernel, suite::Mode mode, const timing::Inputs<double>& first,
                           const timing::Inputs<double>& second) {
  const std::vector<timing::Rival> rivals{rival_of(kernel, mode, first), rival_of(kernel, mode, second),
                                          timing::sentinel()};
  const auto laps = timing::race("honesty", rivals, {});
  std::vector<double> ratios;
  for (std::size_t round = 0; round < laps[0].ns_per_point.size(); ++round)
    ratios.push_back(laps[1].ns_per_point[round] / laps[0].ns_per_point[round]);
  return metric::verdict(metric::median_interval(ratios, metric::timing_confidence));
}

/// How often `expected` came out of 100 races; prints what came out.
int count(std::string_view contest, suite::Mode mode, std::size_t evaluations, metric::Verdict expected) {
  const auto& kernel = *find_kernel<double>("de_casteljau", Form::bernstein, 2);
  const auto first = inputs_of(charged);
  const auto second = inputs_of(evaluations);
  std::map<metric::Verdict, int> verdicts;
  for (int race = 0; race < races; ++race) ++verdicts[verdict_of(kernel, mode, first, second)];
  fmt::print("{:<16} {:<6}", contest, suite::name(mode));
  for (const auto verdict :
       {metric::Verdict::same, metric::Verdict::slower, metric::Verdict::faster, metric::Verdict::unresolved})
    fmt::print("  {} {:>3}", metric::name(verdict), verdicts[verdict]);
  fmt::print("   {} {} at least: {}\n", metric::name(expected), enough, verdicts[expected] >= enough ? "yes" : "NO");
  return verdicts[expected];
}

}  // namespace

int main() {
  bool honest = true;
  for (const auto mode : {suite::Mode::point, suite::Mode::batch}) {
    honest = count("against itself", mode, charged, metric::Verdict::same) >= enough && honest;
    honest = count("3 % more work", mode, evaluations_if_slower, metric::Verdict::slower) >= enough && honest;
  }
  return honest ? 0 : 1;
}
