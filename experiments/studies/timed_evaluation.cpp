// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_evaluation.hpp"

#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/timed_check.hpp"
#include "experiments/studies/timed_inputs.hpp"
#include "experiments/timing/kernel_rival.hpp"

namespace bezierbench::studies {
namespace {

template <class Scalar>
std::vector<const MethodInfo*> methods_of(const suite::Study& study, const sample::Cell& cell) {
  std::vector<const MethodInfo*> methods;
  for (const auto* kernel : chosen_kernels<Scalar>(study, cell.dimension))
    if (kernel->info->template supports<Scalar>(cell.degree)) methods.push_back(kernel->info);
  return methods;
}

template <class Scalar>
JudgedRivals rivals(const Heat& heat, const suite::Study& study, std::uint64_t seed) {
  const auto inputs = std::make_shared<const timing::Inputs<Scalar>>(timed_inputs<Scalar>(study, heat.cell, seed));
  JudgedRivals contestants{{}, {}, inputs};
  for (const auto* info : heat.methods) {
    const auto& kernel = *find_method<Scalar>(info->id, info->form, heat.cell.dimension);
    auto judged = judge(kernel, heat.mode, *inputs);
    contestants.right.push_back(judged.right);
    contestants.rivals.push_back(timing::kernel_rival(kernel, heat.mode, *inputs, std::move(judged.points)));
  }
  return contestants;
}

}  // namespace

std::vector<Heat> heats_of_evaluation(const suite::Study& study) {
  const auto asked = asked_of(study, {}, name(Problem::evaluation)).front();
  std::vector<Heat> heats;
  for (const auto scalar : study.scalar)
    for (const auto& cell : sample::cells(study))
      for (const auto mode : study.modes)
        heats.push_back(
            {cell, scalar, mode,
             scalar == suite::ScalarKind::float32 ? methods_of<float>(study, cell) : methods_of<double>(study, cell),
             asked});
  return heats;
}

JudgedRivals rivals_of_evaluation(const Heat& heat, const suite::Study& study, std::uint64_t seed) {
  return heat.scalar == suite::ScalarKind::float32 ? rivals<float>(heat, study, seed)
                                                   : rivals<double>(heat, study, seed);
}

}  // namespace bezierbench::studies
