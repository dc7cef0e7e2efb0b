// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/conversion.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array conversion_fields{field<&ConversionKeys::published>(published_key)};

Finding check_conversion(const Study& study, const Vocabulary& known) {
  return check_published(keys_of<ConversionKeys>(study).published, known);
}

}  // namespace

const Kind& ConversionKeys::kind() {
  static constexpr Kind kind{
      .id = "conversion",
      .about = "errors of the coefficients in another form",
      .own = conversion_fields,
      .methods_example = "[\"factorial+positive_sum\"]",
      .inputs = {.forms = polynomial_forms, .forms_reason = "conversions take polynomial curves", .double_only = true},
      .chains = true,
      .keys = default_keys<ConversionKeys>,
      .check = check_conversion};
  return kind;
}

}  // namespace bezierbench::suite
