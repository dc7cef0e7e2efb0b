// SPDX-License-Identifier: MIT
#include "experiments/suite/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/curve_view.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/text/toml_value.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array shared{
    field<&Study::id>({.key = "id",
                       .meaning = "name of the study in files and options, unique over a bundle",
                       .example = "\"my-study\"",
                       .required = true,
                       .settable = false}),
    field<&Study::title>({.key = "title",
                          .meaning = "what it is about, for people",
                          .example = "\"Errors by degree\"",
                          .left_out = "none",
                          .settable = false}),
    field<&Study::kind>({.key = "kind",
                         .meaning = "kind of the study",
                         .example = "\"accuracy\"",
                         .left_out = "nothing: it is required",
                         .required = true,
                         .settable = false}),
    field<&Study::form>({.key = "curve",
                         .meaning = "form in which random curves are drawn, or which curves of the sets are taken",
                         .example = "\"bernstein\"",
                         .left_out = "bernstein; of curve sets all forms",
                         .settable = false}),
    field<&Study::dimension>(
        {.key = "dimension",
         .meaning = "numbers of coordinates, 1 to 3; of curve sets all that there are, if left out",
         .example = "[2, 3]",
         .axis = Axis::of_cells}),
    field<&Study::degree>(
        {.key = "degree",
         .meaning = "degrees of the curves, 0 to 1023",
         .example = "[3, 5]",
         .left_out = "those of the curve sets; without these only numbers of points can take its place",
         .axis = Axis::of_cells}),
    field<&Study::coordinate_range>({.key = "coordinate_range",
                                     .meaning = "ranges R of the coordinates, which lie in [-R, R]",
                                     .example = "[1, 1e6]",
                                     .axis = Axis::of_cells,
                                     .curves = Curves::drawn}),
    field<&Study::t_interval>({.key = "t_interval",
                               .meaning = "intervals [a, b] from which parameters are drawn",
                               .example = "[[0, 1]]",
                               .axis = Axis::of_cells,
                               .curves = Curves::drawn}),
    field<&Study::generator>({.key = "generator",
                              .meaning = "how random inputs are drawn, see list generators; for rational curves the "
                                         "default is the first that draws weights",
                              .example = "[\"continuous\"]",
                              .axis = Axis::of_cells,
                              .curves = Curves::drawn}),
    field<&Study::curves>({.key = "curves",
                           .meaning =
                               "curve sets whose curves are the inputs, instead of drawn ones: files, relative to the "
                               "suite, or ids of shipped sets; SET#GLOB takes the curves with such ids",
                           .example = "[\"named\"]",
                           .left_out = "none: curves are drawn",
                           .settable = false,
                           .curves = Curves::of_sets}),
    field<&Study::curves_sha256>(
        {.key = "curves_sha256",
         .meaning = "the SHA-256 that the numbers of each curve set must have; a run writes it",
         .example = "[\"9f86d081884c7d65...\"]",
         .left_out = "not checked",
         .settable = false,
         .curves = Curves::of_sets}),
    field<&Study::parameters>({.key = "parameters",
                               .meaning = "number of parameters for each curve of a set",
                               .example = "16",
                               .curves = Curves::of_sets}),
    field<&Study::parameters_from>(
        {.key = "parameters_from",
         .meaning =
             "which parameters of [0, 1]: drawn, on a grid with both ends, or those stored in the column t of the set",
         .example = "\"stored\"",
         .settable = false,
         .curves = Curves::of_sets}),
    field<&Study::placement>({.key = "placement",
                              .meaning =
                                  "where the curves of a set lie: as stored; scaled by a drawn factor; translated by a "
                                  "drawn offset, as on a page",
                              .example = "[\"stored\", \"translated\"]",
                              .axis = Axis::of_cells,
                              .curves = Curves::of_sets}),
    field<&Study::scalar>({.key = "scalar",
                           .meaning = "types in which methods compute",
                           .example = "[\"double\"]",
                           .axis = Axis::of_cells}),
    field<&Study::methods>(
        {.key = "methods",
         .meaning = "ids or globs, see list methods; a kind conversion takes conversions joined by +",
         .example = {},
         .left_out = "all that apply"}),
    field<&Study::trials>({.key = "trials",
                           .meaning = "random inputs per cell and replicate; times have rounds of their own",
                           .example = "1000",
                           .curves = Curves::drawn}),
    field<&Study::replicates>({.key = "replicates",
                               .meaning = "independent repetitions of the trials, 1 to 1000000",
                               .example = "2",
                               .curves = Curves::drawn}),
    field<&Study::baseline>({.key = "baseline",
                             .meaning = "what results are compared with: exact or ids of methods; other kinds than "
                                        "accuracy and timing have exact only",
                             .example = "\"exact\"",
                             .bare_if_single = true})};

Finding check_form(const Study& study, const Inputs& inputs) {
  if (std::ranges::count(inputs.forms, study.form) > 0) return std::nullopt;
  std::vector<std::string> forms;
  for (const Form form : inputs.forms) forms.push_back(fmt::format("\"{}\"", name(form)));
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
  if (!has_sets(study) || study.places.keys.contains("curve"))
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
               fmt::format("the problem {} {} the key {}; {} it", name(problem), wanted ? "requires" : "does not have",
                           field.key, wanted ? "add" : "remove")};
}

static_assert(max_degree == 1023 && most_replicates == 1000000, "the meanings of degree and replicates state them");

template <class T>
bool says_nothing(const T& value) {
  if constexpr (requires { value.empty(); })
    return value.empty();
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return value == 0;
  else if constexpr (std::is_same_v<T, Counting>)
    return value == Counting::none;
  else
    return false;
}

template <class T>
std::size_t count(const T& /*value*/) {
  return 1;
}
template <class T>
std::size_t count(const std::vector<T>& values) {
  return values.empty() ? 1 : values.size();
}

}  // namespace

const Kind& kind_of(const Study& study) {
  if (study.kind == nullptr) throw std::logic_error(study.id + ": a study without a kind");
  return *study.kind;
}

std::span<const Field> shared_fields() { return shared; }

std::vector<const Field*> fields_of(const Kind& kind) {
  std::vector<const Field*> fields;
  for (const Field& field : shared)
    if (std::ranges::find(kind.without, field.key) == kind.without.end() &&
        (field.key != "degree" || kind.inputs.degree != DegreeUse::not_a_key) &&
        (field.curves != Curves::of_sets || kind.inputs.sets != SetUse::none))
      fields.push_back(&field);
  for (const Field& field : kind.own) fields.push_back(&field);
  return fields;
}

bool is_required(const Kind& kind, const Field& field) {
  if (field.key == "curves") return kind.inputs.sets == SetUse::required;
  return field.required || (field.key == "degree" && kind.inputs.degree == DegreeUse::required);
}

bool applies(const Field& field, const Study& study) {
  if (field.key == "curve" && has_sets(study)) return study.places.keys.contains(field.key);  // a choice of curves
  if (field.curves == Curves::drawn) return !has_sets(study) || kind_of(study).inputs.sets == SetUse::required;
  return field.curves == Curves::any || has_sets(study);
}

const Field* find_field(const Kind& kind, std::string_view key) {
  const auto fields = fields_of(kind);
  const auto found = std::ranges::find(fields, key, &Field::key);
  return found == fields.end() ? nullptr : *found;
}

std::string foreign_key_problem(const Kind& kind, std::string_view key, std::span<const Kind* const> kinds) {
  std::vector<std::string_view> others;
  for (const Kind* other : kinds)
    if (find_field(*other, key) != nullptr) others.push_back(other->id);
  if (others.empty()) return {};
  const bool is_degree = key == "degree";
  return fmt::format("kind \"{}\" does not have the key {}{}{}; kind{} {} ha{} it", kind.id, key, is_degree ? ": " : "",
                     is_degree ? kind.inputs.degree_reason : "", others.size() == 1 ? "" : "s", fmt::join(others, ", "),
                     others.size() == 1 ? "s" : "ve");
}

Finding check_inputs(const Study& study, std::span<const KnownGenerator> generators) {
  const Kind& kind = kind_of(study);
  return check_inputs_of(study, kind.inputs, fmt::format("kind \"{}\"", kind.id), generators);
}

Finding check_timed(const Study& study, const Kind& judged, std::span<const KnownGenerator> generators) {
  const Problem problem = judged.problem.value();
  if (problem != Problem::evaluation) {
    if (auto found = check_inputs_of(study, judged.inputs, fmt::format("the problem {}", name(problem)), generators))
      return found;
    if (study.modes != std::vector{Mode::one_shot})
      return Fault{"modes", 0, "methods",
                   "a companion problem is timed from the control points on; write modes = [\"one_shot\"]"};
  }
  for (const Field* field : fields_of(kind_of(study)))
    if (field->key == "degree" || field->axis == Axis::of_cases)
      if (auto found = check_asked(study, problem, *field, sweeps(judged, field->key))) return found;
  return std::nullopt;
}

bool is_empty(const Field& field, const Study& study) {
  return std::visit([](const auto* value) { return says_nothing(*value); }, field.value(study));
}

std::size_t sweep_length(const Field& field, const Study& study) {
  if (field.axis == Axis::none) return 1;
  return std::visit([](const auto* value) { return count(*value); }, field.value(study));
}

std::string to_text(const Field& field, const Study& study) {
  if (is_empty(field, study)) return {};  // a key left out does not apply, or means all methods that apply
  return std::visit([](const auto* value) { return to_text(*value); }, field.value(study));
}

}  // namespace bezierbench::suite
