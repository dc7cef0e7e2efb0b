// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/accuracy.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array accuracy_fields{
    field<&AccuracyKeys::decomposed_trials>(
        {.key = "decomposed_trials",
         .meaning = "so many trials of the first replicate of a cell have their error taken apart by its sources",
         .example = "100",
         .left_out = "0"}),
    field<&AccuracyKeys::published>(published_key)};

Finding check_accuracy(const Study& study, const Vocabulary& known) {
  const auto& keys = keys_of<AccuracyKeys>(study);
  if (keys.decomposed_trials < 0) return Fault{"decomposed_trials", 0, {}, "decomposed_trials must not be negative"};
  return check_published(keys.published, known);
}

}  // namespace

const Kind& AccuracyKeys::kind() {
  static constexpr Kind kind{.id = "accuracy",
                             .about = "errors of points on random curves, of every method",
                             .own = accuracy_fields,
                             .methods_example = "[\"de_casteljau\", \"horner_bernstein\"]",
                             .has_baseline = true,
                             .keys = default_keys<AccuracyKeys>,
                             .check = check_accuracy};
  return kind;
}

}  // namespace bezierbench::suite
