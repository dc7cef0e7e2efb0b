// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/timed_evaluation.hpp"

#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/race/kernel_rival.hpp"

namespace bezierbench::studies {
namespace {

template <class Scalar>
std::vector<const MethodInfo*> methods_of(const suite::Study& study, const sample::Cell& cell) {
  std::vector<const MethodInfo*> methods;
  for (const auto* kernel : judge::chosen_kernels<Scalar>(study, cell))
    if (kernel->info->template supports<Scalar>(cell.degree)) methods.push_back(kernel->info);
  return methods;
}

template <class Scalar>
race::JudgedRivals rivals(const race::Race& race, const suite::Study& study, std::uint64_t seed) {
  const auto inputs = std::make_shared<const race::Inputs<Scalar>>(race::timed_inputs<Scalar>(study, race.cell, seed));
  race::JudgedRivals all{{}, {}, inputs};
  for (const auto* info : race.methods) {
    const auto& kernel = *judge::find_method<Scalar>(info->id, info->form, race.cell.dimension);
    auto judged = race::judge_points(kernel, race.mode, *inputs);
    all.judged.push_back({judged.right, judged.max_error_u});
    all.rivals.push_back(race::kernel_rival(kernel, race.mode, *inputs, std::move(judged.points)));
  }
  all.call = race::call_rival(race.mode, *inputs);
  return all;
}

}  // namespace

std::vector<race::Race> races_of_evaluation(const suite::Study& study) {
  std::vector<race::Race> races;
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      for (const auto mode : study.modes)
        races.push_back(
            {cell,
             scalar,
             mode,
             judge::with_scalar(scalar, [&]<class Scalar>(Scalar /*zero*/) { return methods_of<Scalar>(study, cell); }),
             {}});
  return races;
}

race::JudgedRivals rivals_of_evaluation(const race::Race& race, const suite::Study& study, std::uint64_t seed,
                                        std::shared_ptr<const void>& /*trials*/) {
  return judge::with_scalar(race.scalar,
                            [&]<class Scalar>(Scalar /*zero*/) { return rivals<Scalar>(race, study, seed); });
}

}  // namespace bezierbench::studies
