// SPDX-License-Identifier: MIT
// Which inputs a kind of study takes, and which a companion problem takes where it is timed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/number/number.hpp"
#include "experiments/suite/kinds.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::suite {
namespace {

Finding check_form(const Study& study, const Inputs& inputs) {
  if (std::ranges::count(inputs.forms, study.curve) > 0) return std::nullopt;
  std::vector<std::string> forms;
  for (const Form form : inputs.forms) forms.push_back(fmt::format("\"{}\"", suite::name(form)));
  return Fault{"curve", 0, "kind", fmt::format("{}; write curve = {}", inputs.forms_reason, fmt::join(forms, " or "))};
}

Finding check_scalar(const Study& study, std::string_view what) {
  for (std::size_t k = 0; k < study.scalar.size(); ++k)
    if (study.scalar[k] != ScalarKind::float64)
      return Fault{"scalar", k, "kind", fmt::format("{} is computed in double only; leave scalar out", what)};
  return std::nullopt;
}

Finding check_parameters(const Study& study, const Inputs& inputs) {
  for (std::size_t k = 0; k < study.t_interval.size(); ++k) {
    const Interval& t = study.t_interval[k];
    if (inputs.parameters == Parameters::whole && t != Interval{})
      return Fault{"t_interval", k, "kind", fmt::format("{}; leave t_interval out", inputs.parameters_reason)};
    if (inputs.parameters == Parameters::from_0_to_1 && (t.min < 0 || t.max > 1))
      return Fault{"t_interval", k, "kind",
                   fmt::format("t_interval {}:{} is {} and must be within 0 and 1", number::decimal(t.min),
                               number::decimal(t.max), inputs.parameters_reason)};
  }
  return std::nullopt;
}

Finding check_degree(const Study& study, const Inputs& inputs) {
  for (std::size_t k = 0; k < study.degree.size(); ++k)
    if (study.degree[k] < inputs.least_degree)
      return Fault{"degree", k, "kind",
                   fmt::format("{}; remove the degree {}", inputs.least_degree_reason, study.degree[k])};
  return std::nullopt;
}

Finding check_independence(const Study& study, std::span<const KnownGenerator> generators) {
  for (std::size_t k = 0; k < study.generator.size(); ++k)
    for (const KnownGenerator& generator : generators)
      if (generator.id == study.generator[k] && generator.limits.whole_curve)
        return Fault{"generator", k, "kind",
                     fmt::format("generator \"{}\" draws a curve as a whole, not points; choose another, see `list "
                                 "generators`",
                                 generator.id)};
  return std::nullopt;
}

/// Checks the inputs of `study` against `inputs`. Messages name the kind or problem by `what`.
Finding check_inputs_of(const Study& study, const Inputs& inputs, std::string_view what,
                        std::span<const KnownGenerator> generators) {
  if (auto found = check_form(study, inputs)) return found;
  if (inputs.double_only)
    if (auto found = check_scalar(study, what)) return found;
  if (auto found = check_parameters(study, inputs)) return found;
  if (auto found = check_degree(study, inputs)) return found;
  return inputs.independent_points ? check_independence(study, generators) : std::nullopt;
}

/// Whether `key` is an axis of this kind.
bool sweeps(const Kind& kind, std::string_view key) {
  const Field* field = find_field(kind, key);
  return field != nullptr && field->axis != Axis::none;
}

/// Checks that a timing study has the axis `field` if and only if the problem that it times has it (`wanted`).
Finding check_asked(const Study& study, Problem problem, const Field& field, bool wanted) {
  if (is_empty(field, study) != wanted) return std::nullopt;
  return Fault{field.key,
               Fault::key_itself,
               {},
               fmt::format("the problem {} {} the key {}; {} it", name(problem), wanted ? "needs" : "does not have",
                           field.key, wanted ? "add" : "remove")};
}

}  // namespace

Finding check_inputs(const Study& study, std::span<const KnownGenerator> generators) {
  const Kind& kind = kind_of(study);
  return check_inputs_of(study, kind.inputs, fmt::format("kind \"{}\"", kind.id), generators);
}

Finding check_timed(const Study& study, Problem problem, std::span<const KnownGenerator> generators) {
  const auto companion =
      std::ranges::find_if(kinds(), [&](const Kind* kind) { return kind->companion == std::optional(problem); });
  const bool is_companion = companion != kinds().end();
  if (is_companion) {
    const auto what = fmt::format("the problem {}", name(problem));
    if (auto found = check_inputs_of(study, (*companion)->inputs, what, generators)) return found;
    if (keys_of<TimingKeys>(study).modes != std::vector{Mode::one_shot})
      return Fault{"modes", 0, "methods",
                   "a companion problem is timed from the control points on; write modes = [\"one_shot\"]"};
  }
  const Field& degree = *find_field(TimingKeys::kind(), "degree");
  if (auto found = check_asked(study, problem, degree, !is_companion || sweeps(**companion, degree.key))) return found;
  for (const Field& field : TimingKeys::kind().own)
    if (field.axis == Axis::of_cases)
      if (auto found = check_asked(study, problem, field, is_companion && sweeps(**companion, field.key))) return found;
  return std::nullopt;
}

}  // namespace bezierbench::suite
