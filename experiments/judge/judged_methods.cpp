// SPDX-License-Identifier: MIT
#include "experiments/judge/judged_methods.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/bound/amplification.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::judge {
namespace {

constexpr std::string_view exact_baseline = "exact";

}  // namespace

template <class Scalar>
JudgedMethods<Scalar>::JudgedMethods(const suite::Study& study, const sample::Cell& cell) : degree_(cell.degree) {
  for (const auto* method : chosen_kernels<Scalar>(study, cell)) add(*method);
  add_baselines(study, cell);
}

template <class Scalar>
JudgedMethods<Scalar>::JudgedMethods(const suite::Study& study, const sample::Cell& cell, const Kernel<Scalar>& method)
    : degree_(cell.degree) {
  add(method);
  add_baselines(study, cell);
}

template <class Scalar>
void JudgedMethods<Scalar>::add(const Kernel<Scalar>& method) {
  methods_.emplace_back(method);
  bounds_.emplace_back();
  if (!method.info->bound) return;
  bounds_.back().emplace(*method.info->bound, degree_, ScalarFacts<Scalar>::arithmetic);
  amplifications_.insert(method.info->bound->amplification);
  if (const auto* local = method.info->bound->of_local) amplifications_.insert(local->amplification);
}

template <class Scalar>
void JudgedMethods<Scalar>::add_baselines(const suite::Study& study, const sample::Cell& cell) {
  amplifications_.insert(p_tilde_of(study.form));
  for (std::size_t k = 0; k < study.baseline.size(); ++k) {
    const std::string& id = study.baseline[k];
    const Kernel<Scalar>* kernel = nullptr;
    if (id != exact_baseline) {
      kernel = find_method<Scalar>(id, study.form, cell.dimension);
      if (kernel == nullptr)
        suite::refuse(study, {"baseline", k, "curve",
                              fmt::format("baseline \"{}\" does not take curves in {} form; see `list methods`", id,
                                          name(study.form))});
      if (!takes(*kernel->info, cell.t_interval))
        suite::refuse(study, {"baseline", k, "t_interval", fmt::format("baseline \"{}\" takes t in [0,1] only", id)});
    }
    baselines_.emplace_back();
    if (kernel != nullptr) baselines_.back().emplace(*kernel);
  }
}

template class JudgedMethods<float>;
template class JudgedMethods<double>;

}  // namespace bezierbench::judge
