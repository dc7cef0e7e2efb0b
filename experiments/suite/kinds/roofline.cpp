// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/roofline.hpp"

#include "experiments/suite/goal.hpp"
#include "experiments/suite/kinds.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array roofline_fields{field<&RooflineKeys::goals>(
    {.key = "goals",
     .meaning = "what is asked of batch kernels: of a method, a share of the peak or no_slower_than another method; "
                "scalar, from_degree and to_degree say in which rows, needs_additions_beside on which processors",
     .example = "[{ method = \"horner_bernstein_fma\", share = 0.6 }]",
     .left_out = "none",
     .settable = false})};

Finding check_roofline(const Study& study, const Vocabulary& known) {
  return each("goals", keys_of<RooflineKeys>(study).goals,
              [&](const Goal& goal) { return goal_problem(goal, known.methods); });
}

}  // namespace

const Kind& RooflineKeys::kind() {
  static constexpr Kind kind{
      .id = "roofline",
      .about = "batch kernels against the peak of each instruction set, kernels for a point against its limit",
      .own = roofline_fields,
      .methods_example = "[\"horner_bernstein_fma\"]",
      .timed = true,
      .keys = default_keys<RooflineKeys>,
      .check = check_roofline};
  return kind;
}

}  // namespace bezierbench::suite
