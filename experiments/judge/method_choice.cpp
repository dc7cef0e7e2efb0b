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

template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, int dimension) {
  const Form form = study.curve;
  for (std::size_t k = 0; k < study.methods.size(); ++k) {
    const bool applies = std::ranges::any_of(methods<Scalar>(dimension), [&](const auto& kernel) {
      return kernel.info->form == form && suite::means(study.methods[k], kernel.info->id);
    });
    if (!applies)
      suite::refuse(study,
                    {"methods", k, "curve",
                     fmt::format("method \"{}\" does not take curves in {} form, {} with {} axes; see `list "
                                 "methods`",
                                 study.methods[k], name(form), suite::name(ScalarFacts<Scalar>::kind), dimension)});
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
