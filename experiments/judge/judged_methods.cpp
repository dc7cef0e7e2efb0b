// SPDX-License-Identifier: MIT
#include "experiments/judge/judged_methods.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/basis/amplification.hpp"
#include "experiments/failure.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"

namespace bezierbench::judge {
namespace {

constexpr std::string_view exact_baseline = "exact";

}  // namespace

template <class Scalar>
JudgedMethods<Scalar>::JudgedMethods(const suite::Study& study, const sample::Cell& cell) : degree_(cell.degree) {
  for (const auto* method : chosen_kernels<Scalar>(study, cell)) {
    methods_.emplace_back(*method);
    bounds_.emplace_back();
    if (!method->info->bound) continue;
    bounds_.back().emplace(*method->info->bound, cell.degree, ScalarFacts<Scalar>::arithmetic);
    amplifications_.insert(method->info->bound->amplification);
  }
  amplifications_.insert(p_tilde_of(form_of(study.curve)));
  for (const auto& id : study.baseline) {
    const Kernel<Scalar>* kernel = nullptr;
    if (id != exact_baseline) {
      kernel = find_method<Scalar>(id, form_of(study.curve), cell.dimension);
      if (kernel == nullptr)
        throw Failure(Exit::usage,
                      fmt::format("study \"{}\": baseline \"{}\" does not take curves in {} form; see `list methods`",
                                  study.id, id, name(form_of(study.curve))));
      if (!takes(*kernel->info, cell.t_interval))
        throw Failure(Exit::usage, fmt::format("study \"{}\": baseline \"{}\" takes t in [0,1] only", study.id, id));
    }
    baselines_.emplace_back();
    if (kernel != nullptr) baselines_.back().emplace(*kernel);
  }
}

template class JudgedMethods<float>;
template class JudgedMethods<double>;

}  // namespace bezierbench::judge
