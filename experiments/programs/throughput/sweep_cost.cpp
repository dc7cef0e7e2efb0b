// SPDX-License-Identifier: MIT
#include "experiments/programs/throughput/sweep_cost.hpp"

#include <array>

#include "experiments/judge/methods.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/judge/workspace.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::throughput {
namespace {

constexpr double most_times_bare = 4;

}  // namespace

Comparison sweep_cost(const suite::Study& study) {
  const auto cell = sample::cells(study).front();
  const Form form = study.form;
  const auto kernels = judge::chosen_kernels<double>(study, cell);
  const auto trials = static_cast<std::size_t>(study.trials);
  const sample::Sampler sampler(1, study.id, cell);
  std::vector<judge::TrialInputs<double>> inputs(trials, {form, cell});
  for (std::size_t k = 0; k < trials; ++k) inputs[k].draw(sampler, k);

  double sum = 0;  // keeps the work alive
  judge::PreparedStorage storage;
  const auto bare = [&] {
    std::array<double, 3> point{};
    for (const auto& one : inputs)
      for (const auto* kernel : kernels) {
        if (!kernel->info->supports<double>(cell.degree)) continue;
        judge::evaluate_once<double>(*kernel, one.curve(), one.t(), storage, point);
        sum += point[0];
      }
  };
  const auto judged = [&] {
    const auto job = studies::make_job(study, {1, reference::Tier::certified});
    run::run_all(*job);
  };
  const auto fine = [&] { return sum != -1; };
  const std::vector<race::Rival> rivals{{study.id + ", judged", trials, judged, fine},
                                        {study.id + ", bare evaluation", trials, bare, fine}};
  const auto laps = race::race(study.id, rivals, {.rounds = 20, .least_rounds = 5, .rival_seconds = 2});
  auto comparison = compare(rivals[0], laps[0], rivals[1], laps[1]);
  comparison.goal = most_times_bare;
  comparison.at_least = false;
  return comparison;
}

}  // namespace bezierbench::throughput
