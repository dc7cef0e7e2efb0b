// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/search.hpp"

#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array search_fields{field<&SearchKeys::budget>(
    {.key = "budget",
     .meaning = "how many inputs the search may try per cell and method, after the random trials",
     .example = "20000",
     .left_out = "nothing: it is needed",
     .needed = true})};

Finding check_search(const Study& study, const Vocabulary& /*known*/) {
  if (keys_of<SearchKeys>(study).budget >= 1) return std::nullopt;
  return Fault{"budget",
               0,
               {},
               "kind \"search\" needs a budget of at least 1, how many inputs it may try; write budget = 20000"};
}

}  // namespace

const Kind& SearchKeys::kind() {
  static constexpr Kind kind{.id = "search",
                             .about = "the inputs with the largest error, sought from random ones on",
                             .own = search_fields,
                             .methods_example = "[\"de_casteljau\"]",
                             .keys = default_keys<SearchKeys>,
                             .check = check_search};
  return kind;
}

}  // namespace bezierbench::suite
