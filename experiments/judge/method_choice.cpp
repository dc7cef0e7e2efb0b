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

template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, int dimension) {
  const Form form = form_of(study.curve);
  for (const auto& pattern : study.methods) {
    const bool applies = std::ranges::any_of(methods<Scalar>(dimension), [&](const auto& kernel) {
      return kernel.info->form == form && suite::means(pattern, kernel.info->id);
    });
    if (!applies)
      throw Failure(Exit::usage,
                    fmt::format("study \"{}\": method \"{}\" does not take curves in {} form, {} with {} axes; see "
                                "`list methods`",
                                study.id, pattern, name(form), suite::name(ScalarFacts<Scalar>::kind), dimension));
  }
  std::vector<const Kernel<Scalar>*> chosen;
  const std::vector<std::string> all{"*"};
  for (const auto& kernel : methods<Scalar>(dimension)) {
    if (kernel.info->form != form) continue;
    const bool named = std::ranges::any_of(study.methods.empty() ? all : study.methods,
                                           [&](const auto& pattern) { return suite::means(pattern, kernel.info->id); });
    if (named) chosen.push_back(&kernel);
  }
  return chosen;
}

template std::vector<const Kernel<float>*> chosen_kernels<float>(const suite::Study&, int);
template std::vector<const Kernel<double>*> chosen_kernels<double>(const suite::Study&, int);

}  // namespace bezierbench::judge
