// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/exhaustive.hpp"

#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array exhaustive_fields{field<&ExhaustiveKeys::curves>(
    {.key = "curves",
     .meaning = "ids or globs of named curves, see experiments/studies/exhaustive/named_curves.csv",
     .example = "[\"css_*\", \"circle_tangent\"]",
     .left_out = "nothing: it is needed",
     .needed = true})};

constexpr std::array<std::string_view, 6> keys_without{"dimension", "coordinate_range", "generator",
                                                       "scalar",    "trials",           "replicates"};

Finding check_exhaustive(const Study& study, const Vocabulary& /*known*/) {
  const auto& curves = keys_of<ExhaustiveKeys>(study).curves;
  if (curves.empty()) return Fault{"curves", 0, {}, "curves is empty; name one, such as \"css_ease\""};
  return each("curves", curves, [](const std::string& pattern) {
    return std::string(pattern.empty() ? "curves has an empty name; remove it" : "");
  });
}

}  // namespace

const Kind& ExhaustiveKeys::kind() {
  static constexpr Kind kind{.id = "exhaustive",
                             .about = "every float of an interval: the largest error on named curves, and where it is",
                             .own = exhaustive_fields,
                             .methods_example = "[\"de_casteljau*\"]",
                             .inputs = {.forms = bernstein_form,
                                        .forms_reason = "the named curves are Bezier curves",
                                        .degree = DegreeUse::not_a_key,
                                        .degree_reason = "degree is that of the named curve",
                                        .parameters = Parameters::from_0_to_1,
                                        .parameters_reason = "the named curves are those of t in [0, 1]"},
                             .without = keys_without,
                             .without_reason = "curves are named, methods compute in float, and every t is tried",
                             .keys = default_keys<ExhaustiveKeys>,
                             .check = check_exhaustive};
  return kind;
}

}  // namespace bezierbench::suite
