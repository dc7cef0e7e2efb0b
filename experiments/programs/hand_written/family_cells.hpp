// SPDX-License-Identifier: MIT
// Defines the cells of a family; included by the units that instantiate them.
#pragma once

#include "experiments/programs/hand_written/cells.hpp"
#include "experiments/programs/hand_written/coded_kernel.hpp"
#include "experiments/programs/hand_written/compensated.hpp"
#include "experiments/programs/hand_written/in_parts.hpp"
#include "experiments/programs/hand_written/power_form.hpp"
#include "experiments/programs/hand_written/quotients.hpp"
#include "experiments/programs/hand_written/rational.hpp"
#include "experiments/programs/hand_written/sums.hpp"
#include "experiments/programs/hand_written/triangles.hpp"

namespace bezierbench::programs {

template <class Evaluator, int Dimension, class Scalar, int... Degree>
void append_degrees(Cells<Scalar>& cells, std::integer_sequence<int, Degree...> /*degrees*/) {
  const auto& ours = own_kernel<Evaluator, Scalar>(Dimension);
  (cells.coded.push_back({&Evaluator::info, Degree, &ours, coded_kernel<Evaluator, Scalar, Dimension, Degree>()}), ...);
}

template <class Evaluator, class Scalar>
void append_evaluator(Cells<Scalar>& cells) {
  if constexpr (hand_written::HasCoding<Evaluator>) {
    using Few = std::integer_sequence<int, 3, 10, 20>;
    using Plane =
        std::conditional_t<std::is_same_v<Scalar, double>, std::integer_sequence<int, 1, 2, 3, 5, 10, 20>, Few>;
    append_degrees<Evaluator, 1>(cells, Few());
    append_degrees<Evaluator, 2>(cells, Plane());
    append_degrees<Evaluator, 3>(cells, Few());
  } else {
    cells.without_coding.push_back(&Evaluator::info);
  }
}

template <class Scalar, class... Es>
void append_all(Cells<Scalar>& cells, TypeList<Es...> /*evaluators*/) {
  (append_evaluator<Es>(cells), ...);
}

template <class Scalar, instantiate::Family Family>
void append_cells(Cells<Scalar>& cells) {
  append_all(cells, typename instantiate::Members<Family>::Type());
}

}  // namespace bezierbench::programs
