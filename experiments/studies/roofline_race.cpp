// SPDX-License-Identifier: MIT
#include "experiments/studies/roofline_race.hpp"

#include <fmt/format.h>

#include <map>

#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/timed_check.hpp"
#include "experiments/studies/timed_inputs.hpp"
#include "experiments/timing/peak_rival.hpp"

namespace bezierbench::studies {
namespace {

template <class Scalar>
std::vector<Contestant> contestants_of(const suite::Study& study, const sample::Cell& cell) {
  std::vector<Contestant> methods;
  const auto targets = batch::usable_targets();
  for (const auto* kernel : chosen_kernels<Scalar>(study, cell.dimension)) {
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
  std::vector<Contestant> all;
  for (const auto* target : targets)
    for (const auto work : {Work::multiply_add, Work::multiply_add_and_add})
      all.push_back({work, nullptr, nullptr, target});
  all.insert(all.end(), methods.begin(), methods.end());
  return all;
}

template <class Scalar>
timing::Rival rival_of(const Contestant& who, const Kernel<Scalar>* kernel, const timing::Inputs<Scalar>& inputs,
                       const JudgedPoints<Scalar>& judged) {
  switch (who.work) {
    case Work::scalar_points: return timing::kernel_rival(*kernel, suite::Mode::point, inputs, judged.points);
    case Work::batch_points: return timing::batch_rival(*who.target, *kernel, inputs, judged.points);
    case Work::multiply_add: return timing::peak_rival(batch::table_of<Scalar>(*who.target).multiply_add);
    case Work::multiply_add_and_add: break;
  }
  return timing::peak_rival(batch::table_of<Scalar>(*who.target).multiply_add_and_add);
}

template <class Scalar>
std::vector<timing::Lap> laps_of(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                                 const timing::RaceOptions& options) {
  const auto inputs = timed_inputs<Scalar>(study, race.cell, seed);
  std::map<const MethodInfo*, JudgedPoints<Scalar>> judged;
  std::vector<timing::Rival> rivals;
  for (const auto& who : race.contestants) {
    const Kernel<Scalar>* kernel = nullptr;
    if (who.method != nullptr) {
      kernel = find_method<Scalar>(who.method->id, who.method->form, race.cell.dimension);
      if (!judged.contains(who.method)) judged[who.method] = judge(*kernel, suite::Mode::batch, inputs);
    }
    rivals.push_back(rival_of<Scalar>(who, kernel, inputs, judged[who.method]));
  }
  auto laps = timing::race(fmt::format("{}/{}", study.id, race.cell.degree), rivals, options);
  for (std::size_t k = 0; k < laps.size(); ++k)
    laps[k].checked = laps[k].checked && judged[race.contestants[k].method].right;
  return laps;
}

}  // namespace

std::vector<RooflineRace> roofline_races_of(const suite::Study& study) {
  std::vector<RooflineRace> races;
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      races.push_back({cell, scalar,
                       scalar == suite::ScalarKind::float32 ? contestants_of<float>(study, cell)
                                                            : contestants_of<double>(study, cell)});
  return races;
}

std::vector<timing::Lap> run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                             const timing::RaceOptions& options) {
  return race.scalar == suite::ScalarKind::float32 ? laps_of<float>(race, study, seed, options)
                                                   : laps_of<double>(race, study, seed, options);
}

}  // namespace bezierbench::studies
