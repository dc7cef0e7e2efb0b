// SPDX-License-Identifier: MIT
#include "experiments/judge/method_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/failure.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::judge {

Form form_of(suite::CurveKind curve) {
  switch (curve) {
    case suite::CurveKind::bezier: break;
    case suite::CurveKind::polynomial: return Form::power;
    case suite::CurveKind::rational: return Form::rational;
  }
  return Form::bernstein;
}

bool takes(const MethodInfo& info, const suite::Interval& t_interval) {
  return !info.unit_interval_only || (t_interval.min >= 0 && t_interval.max <= 1);
}

template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, const sample::Cell& cell) {
  const Form form = form_of(study.curve);
  const int dimension = cell.dimension;
  for (const auto& pattern : study.methods) {
    const MethodInfo* named = nullptr;
    bool somewhere = false;
    for (const auto& kernel : methods<Scalar>(dimension)) {
      if (kernel.info->form != form || !suite::means(pattern, kernel.info->id)) continue;
      named = kernel.info;
      somewhere = somewhere || std::ranges::any_of(study.t_interval, [&](const auto& t) { return takes(*named, t); });
    }
    if (named != nullptr && !somewhere)
      throw Failure(Exit::usage, fmt::format("study \"{}\": method \"{}\" takes t in [0,1] only; narrow t_interval or "
                                             "leave it out",
                                             study.id, pattern));
    if (named == nullptr)
      throw Failure(Exit::usage,
                    fmt::format("study \"{}\": method \"{}\" does not take curves in {} form, {} with {} axes; see "
                                "`list methods`",
                                study.id, pattern, name(form), suite::name(ScalarFacts<Scalar>::kind), dimension));
  }
  std::vector<const Kernel<Scalar>*> chosen;
  const std::vector<std::string> all{"*"};
  for (const auto& kernel : methods<Scalar>(dimension)) {
    if (kernel.info->form != form || !takes(*kernel.info, cell.t_interval)) continue;
    const bool named = std::ranges::any_of(study.methods.empty() ? all : study.methods,
                                           [&](const auto& pattern) { return suite::means(pattern, kernel.info->id); });
    if (named) chosen.push_back(&kernel);
  }
  return chosen;
}

template std::vector<const Kernel<float>*> chosen_kernels<float>(const suite::Study&, const sample::Cell&);
template std::vector<const Kernel<double>*> chosen_kernels<double>(const suite::Study&, const sample::Cell&);

}  // namespace bezierbench::judge
