// SPDX-License-Identifier: MIT
#include "experiments/judge/method_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::judge {

bool takes(const MethodInfo& info, const suite::Interval& t_interval) {
  return !info.unit_interval_only || (t_interval.min >= 0 && t_interval.max <= 1);
}

template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, const sample::Cell& cell) {
  const Form form = study.curve;
  const int dimension = cell.dimension;
  for (std::size_t k = 0; k < study.methods.size(); ++k) {
    const std::string& pattern = study.methods[k];
    const MethodInfo* named = nullptr;
    bool somewhere = false;
    for (const auto& kernel : methods<Scalar>(dimension)) {
      if (kernel.info->form != form || !suite::means(pattern, kernel.info->id)) continue;
      named = kernel.info;
      somewhere = somewhere || std::ranges::any_of(study.t_interval, [&](const auto& t) { return takes(*named, t); });
    }
    if (named != nullptr && !somewhere)
      suite::refuse(study,
                    {"methods", k, "t_interval",
                     fmt::format("method \"{}\" takes t in [0,1] only; narrow t_interval or leave it out", pattern)});
    if (named == nullptr)
      suite::refuse(study, {"methods", k, "curve",
                            fmt::format("method \"{}\" does not take curves in {} form, {} with {} axes; see `list "
                                        "methods`",
                                        pattern, name(form), suite::name(ScalarFacts<Scalar>::kind), dimension)});
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
