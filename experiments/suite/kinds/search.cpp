// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/search.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array search_fields{field<&SearchKeys::budget>(
    budget_key("how many inputs the search may try per cell and method, after the random trials"))};

Finding check_search(const Study& study, const Vocabulary& /*known*/) {
  return check_budget(SearchKeys::kind().id, keys_of<SearchKeys>(study).budget);
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
