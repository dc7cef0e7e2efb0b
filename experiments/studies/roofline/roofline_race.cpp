// SPDX-License-Identifier: MIT
#include "experiments/studies/roofline/roofline_race.hpp"

#include <fmt/format.h>

#include <map>

#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/observed_error.hpp"
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
    for (const auto* target : targets)
      if (batch::find(*target, *kernel))
        methods.push_back({Work::batch_points, target, kernel->info, kernel->evaluator});
  }
  if (methods.empty()) return {};
  std::vector<TargetRival> all;
  for (const auto* target : targets)
    for (const auto work : {Work::multiply_add, Work::multiply_add_and_add}) all.push_back({work, target});
  all.insert(all.end(), methods.begin(), methods.end());
  return all;
}

template <class Scalar>
race::Rival rival_of(const TargetRival& who, const Kernel<Scalar>* kernel, const race::Inputs<Scalar>& inputs,
                     const race::JudgedPoints<Scalar>& judged) {
  switch (who.work) {
    case Work::batch_points: return race::batch_rival(*who.target, *kernel, inputs, judged.points);
    case Work::multiply_add: return race::peak_rival(batch::works_of<Scalar>(*who.target).back().multiply_add());
    case Work::multiply_add_and_add: break;
  }
  return race::peak_rival(batch::works_of<Scalar>(*who.target).back().multiply_add_and_add);
}

/// No accuracy study says what errors of a method without a proved bound may be.
template <class Scalar>
bool is_right(const race::JudgedPoints<Scalar>& judged) {
  const double allowed = metric::allowed_error_u(std::nullopt, judge::ScalarFacts<Scalar>::arithmetic.unit_roundoff);
  return judged.right && judged.max_error_u.value_or(0) <= allowed;
}

template <class Scalar>
RooflineTimes times_of(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                       const race::RaceOptions& options) {
  const auto inputs = race::timed_inputs<Scalar>(study, race.cell, seed);
  std::map<const MethodInfo*, race::JudgedPoints<Scalar>> judged;
  std::vector<race::Rival> rivals;
  for (const auto& who : race.rivals) {
    const Kernel<Scalar>* kernel = nullptr;
    if (who.method != nullptr) {
      kernel = judge::find_method<Scalar>(who.method->id, who.method->form, race.cell.dimension);
      if (!judged.contains(who.method)) judged[who.method] = race::judge_points(*kernel, suite::Mode::batch, inputs);
    }
    rivals.push_back(rival_of<Scalar>(who, kernel, inputs, judged[who.method]));
  }
  auto times = race::time_rounds(fmt::format("{}/{}", study.id, race.cell.degree), rivals, options);
  for (std::size_t k = 0; k < times.size(); ++k)
    times[k].checked = times[k].checked && is_right<Scalar>(judged[race.rivals[k].method]);
  return times;
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

RooflineTimes run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                  const race::RaceOptions& options) {
  return judge::with_scalar(
      race.scalar, [&]<class Scalar>(Scalar /*zero*/) { return times_of<Scalar>(race, study, seed, options); });
}

}  // namespace bezierbench::studies
