// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/companion/derivative.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array derivative_fields{field<&DerivativeKeys::order>(order_key)};

Finding check_derivative(const Study& study, const Vocabulary& /*known*/) {
  return check_orders(keys_of<DerivativeKeys>(study).order);
}

}  // namespace

const Kind& DerivativeKeys::kind() {
  static constexpr Kind kind{.id = "derivative",
                             .about = "errors of derivatives at one parameter",
                             .own = derivative_fields,
                             .methods_example = "[\"differences_horner\"]",
                             .inputs = {.forms = polynomial_forms,
                                        .forms_reason = "derivatives are those of polynomial curves",
                                        .double_only = true},
                             .companion = Problem::derivative,
                             .keys = default_keys<DerivativeKeys>,
                             .check = check_derivative};
  return kind;
}

}  // namespace bezierbench::suite
