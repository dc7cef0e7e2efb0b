// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <type_traits>

#include "core/curve_view.hpp"

namespace bezierbench::suite {
namespace {

/// The function `kind` of each alternative of KindKeys. The argument, a null pointer, only passes the type of the
/// variant.
template <class... Keys>
constexpr std::array<const Kind& (*)(), sizeof...(Keys)> functions_of(std::variant<Keys...>* /*which*/) {
  return {&Keys::kind...};
}

/// `member(keys)` for the keys of the study's kind; empty where these keys do not have that member.
template <class T, class Member>
const std::vector<T>& axis_of(const Study& study, Member member) {
  static const std::vector<T> none;
  return std::visit(
      [member](const auto& keys) -> const std::vector<T>& {
        if constexpr (std::is_invocable_v<Member, decltype(keys)>)
          return member(keys);
        else
          return none;
      },
      study.keys);
}

std::vector<const Kind*> kinds_with(std::string_view key) {
  std::vector<const Kind*> having;
  for (const Kind* kind : kinds())
    if (find_field(*kind, key) != nullptr) having.push_back(kind);
  return having;
}

constexpr std::array shared{
    field<&Study::id>({.key = "id",
                       .meaning = "name of the study in files and options, unique over a bundle",
                       .example = "\"my-study\"",
                       .needed = true,
                       .settable = false}),
    field<&Study::title>({.key = "title",
                          .meaning = "what it is about, for people",
                          .example = "\"Errors by degree\"",
                          .left_out = "none",
                          .settable = false}),
    field<&Study::keys>({.key = "kind",
                         .meaning = "kind of the study",
                         .example = "\"accuracy\"",
                         .left_out = "nothing: it is needed",
                         .needed = true,
                         .settable = false}),
    field<&Study::curve>({.key = "curve",
                          .meaning = "form in which random curves are drawn",
                          .example = "\"bezier\"",
                          .settable = false}),
    field<&Study::dimension>(
        {.key = "dimension", .meaning = "numbers of coordinates, 1 to 3", .example = "[2, 3]", .axis = Axis::of_cells}),
    field<&Study::degree>({.key = "degree",
                           .meaning = "degrees of the curves, 0 to 1023",
                           .example = "[3, 5]",
                           .left_out = "none; only numbers of points can take its place",
                           .axis = Axis::of_cells}),
    field<&Study::coordinate_range>({.key = "coordinate_range",
                                     .meaning = "ranges R of the coordinates, which lie in [-R, R]",
                                     .example = "[1, 1e6]",
                                     .axis = Axis::of_cells}),
    field<&Study::t_interval>({.key = "t_interval",
                               .meaning = "intervals [a, b] from which parameters are drawn",
                               .example = "[[0, 1]]",
                               .axis = Axis::of_cells}),
    field<&Study::generator>({.key = "generator",
                              .meaning = "how random inputs are drawn, see list generators; for rational curves the "
                                         "default is the first that draws weights",
                              .example = "[\"continuous\"]",
                              .axis = Axis::of_cells}),
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
                           .example = "1000"}),
    field<&Study::replicates>(
        {.key = "replicates", .meaning = "independent repetitions of the trials, 1 to 1000000", .example = "2"}),
    field<&Study::baseline>({.key = "baseline",
                             .meaning = "what results are compared with: exact or ids of methods; other kinds than "
                                        "accuracy and timing have exact only",
                             .example = "\"exact\"",
                             .bare_if_single = true})};

static_assert(max_degree == 1023 && most_replicates == 1000000, "the meanings of degree and replicates state them");

}  // namespace

std::span<const Kind* const> kinds() {
  static const auto all = [] {
    constexpr auto functions = functions_of(static_cast<KindKeys*>(nullptr));
    std::array<const Kind*, functions.size()> found{};
    std::ranges::transform(functions, found.begin(), [](const auto function) { return &function(); });
    return found;
  }();
  return all;
}

const Kind* find_kind(std::string_view id) {
  const auto found = std::ranges::find(kinds(), id, &Kind::id);
  return found == kinds().end() ? nullptr : *found;
}

const Kind& kind_of(const Study& study) { return *kinds()[study.keys.index()]; }

std::span<const Field> shared_fields() { return shared; }

std::vector<const Field*> fields_of(const Kind& kind) {
  std::vector<const Field*> fields;
  for (const Field& field : shared)
    if (std::ranges::find(kind.without, field.key) == kind.without.end() &&
        (field.key != "degree" || kind.inputs.degree != DegreeUse::not_a_key))
      fields.push_back(&field);
  for (const Field& field : kind.own) fields.push_back(&field);
  return fields;
}

bool needs(const Kind& kind, const Field& field) {
  return field.needed || (field.key == "degree" && kind.inputs.degree == DegreeUse::needed);
}

const Field* find_field(const Kind& kind, std::string_view key) {
  const auto fields = fields_of(kind);
  const auto found = std::ranges::find(fields, key, &Field::key);
  return found == fields.end() ? nullptr : *found;
}

std::string foreign_key_problem(const Kind& kind, std::string_view key) {
  std::vector<std::string_view> others;
  for (const Kind* other : kinds_with(key)) others.push_back(other->id);
  if (others.empty()) return {};
  const bool is_degree = key == "degree";
  return fmt::format("kind \"{}\" does not have the key {}{}{}; kind{} {} ha{} it", kind.id, key, is_degree ? ": " : "",
                     is_degree ? kind.inputs.degree_reason : "", others.size() == 1 ? "" : "s", fmt::join(others, ", "),
                     others.size() == 1 ? "s" : "ve");
}

const std::vector<int>& orders_of(const Study& study) {
  return axis_of<int>(study, [](const auto& keys) -> decltype((keys.order)) { return keys.order; });
}

const std::vector<int>& points_of(const Study& study) {
  return axis_of<int>(study, [](const auto& keys) -> decltype((keys.points)) { return keys.points; });
}

const std::vector<double>& tolerances_of(const Study& study) {
  return axis_of<double>(study, [](const auto& keys) -> decltype((keys.tolerance)) { return keys.tolerance; });
}

std::string_view published_of(const Study& study) {
  return std::visit(
      [](const auto& keys) -> std::string_view {
        if constexpr (requires { keys.published; })
          return keys.published;
        else
          return {};
      },
      study.keys);
}

}  // namespace bezierbench::suite
