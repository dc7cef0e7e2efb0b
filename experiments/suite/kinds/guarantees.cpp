// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/guarantees.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array guarantees_fields{
    field<&GuaranteesKeys::budget>(
        budget_key("how many inputs the search for a counterexample may try per cell, method and property, after the "
                   "random trials")),
    field<&GuaranteesKeys::properties>({.key = "properties",
                                        .meaning = "which statements, by the names of experiments/guarantees",
                                        .example = "[\"ends_exact\", \"in_hull\"]",
                                        .left_out = "all"})};

constexpr std::array<std::string_view, 3> undrawn{"coordinate_range", "t_interval", "generator"};

Finding check_guarantees(const Study& study, const Vocabulary& /*known*/) {
  return check_budget(GuaranteesKeys::kind().id, keys_of<GuaranteesKeys>(study).budget);
}

}  // namespace

const Kind& GuaranteesKeys::kind() {
  static constexpr Kind kind{
      .id = "guarantees",
      .about = "what methods keep of a curve's properties: proved, refuted by an input, or neither",
      .own = guarantees_fields,
      .methods_example = "[\"de_casteljau*\"]",
      .inputs = {.forms = bernstein_form,
                 .forms_reason = "the properties are of control points",
                 .least_degree = 1,
                 .least_degree_reason = "a curve of degree 0 is a point"},
      .without = undrawn,
      .without_reason = "the statements are about all control points, and each says which t it is about",
      .keys = default_keys<GuaranteesKeys>,
      .check = check_guarantees};
  return kind;
}

}  // namespace bezierbench::suite
