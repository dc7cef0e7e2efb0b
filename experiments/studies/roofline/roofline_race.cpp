// SPDX-License-Identifier: MIT
#include "experiments/studies/roofline/roofline_race.hpp"

#include <fmt/format.h>

#include <map>

#include "experiments/judge/method_choice.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/race/peak_rival.hpp"
#include "experiments/race/timed_check.hpp"
#include "experiments/race/timed_inputs.hpp"

namespace bezierbench::studies {
namespace {

template <class Scalar>
std::vector<TargetRival> rivals_of(const suite::Study& study, const sample::Cell& cell) {
  std::vector<TargetRival> methods;
  const auto targets = batch::usable_targets();
  for (const auto* kernel : judge::chosen_kernels<Scalar>(study, cell)) {
    if (!kernel->info->template supports<Scalar>(cell.degree)) continue;
    const auto add = [&](Work work, const batch::Target* target) {
      methods.push_back({work, kernel->info, kernel->evaluator, target});
    };
    const std::size_t before = methods.size();
    for (const auto* target : targets)
      if (batch::find(*target, *kernel)) add(Work::batch_points, target);
    if (methods.size() > before) add(Work::scalar_points, nullptr);
  }
  if (methods.empty()) return {};
  std::vector<TargetRival> all;
  for (const auto* target : targets)
    for (const auto work : {Work::multiply_add, Work::multiply_add_and_add})
      all.push_back({work, nullptr, nullptr, target});
  all.insert(all.end(), methods.begin(), methods.end());
  return all;
}

template <class Scalar>
race::Rival rival_of(const TargetRival& who, const Kernel<Scalar>* kernel, const race::Inputs<Scalar>& inputs,
                     const race::JudgedPoints<Scalar>& judged) {
  switch (who.work) {
    case Work::scalar_points: return race::kernel_rival(*kernel, suite::Mode::point, inputs, judged.points);
    case Work::batch_points: return race::batch_rival(*who.target, *kernel, inputs, judged.points);
    case Work::multiply_add: return race::peak_rival(batch::works_of<Scalar>(*who.target).back().multiply_add());
    case Work::multiply_add_and_add: break;
  }
  return race::peak_rival(batch::works_of<Scalar>(*who.target).back().multiply_add_and_add);
}

template <class Scalar>
std::vector<race::Lap> laps_of(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                               const race::RaceOptions& options) {
  const auto inputs = race::timed_inputs<Scalar>(study, race.cell, seed);
  std::map<const MethodInfo*, race::JudgedPoints<Scalar>> judged;
  std::vector<race::Rival> rivals;
  for (const auto& who : race.rivals) {
    const Kernel<Scalar>* kernel = nullptr;
    if (who.method != nullptr) {
      kernel = judge::find_method<Scalar>(who.method->id, who.method->form, race.cell.dimension);
      if (!judged.contains(who.method)) judged[who.method] = race::judge(*kernel, suite::Mode::batch, inputs);
    }
    rivals.push_back(rival_of<Scalar>(who, kernel, inputs, judged[who.method]));
  }
  auto laps = race::race(fmt::format("{}/{}", study.id, race.cell.degree), rivals, options);
  for (std::size_t k = 0; k < laps.size(); ++k)
    laps[k].checked = laps[k].checked && judged[race.rivals[k].method].right;
  return laps;
}

}  // namespace

std::vector<RooflineRace> roofline_races_of(const suite::Study& study) {
  std::vector<RooflineRace> races;
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      races.push_back(
          {cell, scalar,
           scalar == suite::ScalarKind::float32 ? rivals_of<float>(study, cell) : rivals_of<double>(study, cell)});
  return races;
}

std::vector<race::Lap> run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                           const race::RaceOptions& options) {
  return race.scalar == suite::ScalarKind::float32 ? laps_of<float>(race, study, seed, options)
                                                   : laps_of<double>(race, study, seed, options);
}

}  // namespace bezierbench::studies
