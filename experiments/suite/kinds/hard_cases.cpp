// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/hard_cases.hpp"

#include <fmt/format.h>

#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::int64_t most_kept = 1000;
constexpr std::array hard_cases_fields{
    field<&HardCasesKeys::kept>({.key = "kept",
                                 .meaning = "so many of the trials of a family are kept by each search, 1 to 1000",
                                 .example = "10"})};

constexpr std::array<std::string_view, 5> without{"dimension", "coordinate_range", "t_interval", "generator",
                                                  "methods"};

Finding check_hard_cases(const Study& study, const Vocabulary& /*known*/) {
  const auto kept = keys_of<HardCasesKeys>(study).kept;
  if (kept >= 1 && kept <= most_kept) return std::nullopt;
  return Fault{"kept", 0, {}, fmt::format("kept must be 1 to {}", most_kept)};
}

}  // namespace

const Kind& HardCasesKeys::kind() {
  static constexpr Kind kind{
      .id = "hard_cases",
      .about = "inputs whose exact values are hard to round: ties, numbers beside them, cancellation",
      .own = hard_cases_fields,
      .methods_example = {},
      .inputs = {.forms = polynomial_forms,
                 .forms_reason = "the families are of polynomials",
                 .degree = DegreeUse::not_a_key,
                 .degree_reason = "degree is drawn with the case"},
      .without = without,
      .without_reason = "a family draws the whole case, of one coordinate, and no method takes part",
      .keys = default_keys<HardCasesKeys>,
      .check = check_hard_cases};
  return kind;
}

}  // namespace bezierbench::suite
