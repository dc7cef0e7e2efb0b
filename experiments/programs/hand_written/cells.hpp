// SPDX-License-Identifier: MIT
// The cells that are raced: an evaluator, a scalar, a dimension and a degree, with both codings.
#pragma once

#include <vector>

#include "core/evaluate/kernel.hpp"
#include "core/evaluate/points/point_families.hpp"

namespace bezierbench::programs {

template <class Scalar>
struct Cell {
  const MethodInfo* evaluator;
  int degree;
  const Kernel<Scalar>* ours;
  Kernel<Scalar> by_hand;
};

template <class Scalar>
struct Cells {
  std::vector<Cell<Scalar>> coded;
  std::vector<const MethodInfo*> without_coding;
};

/// The cells of a family of evaluators, in roster order. Each family is a unit of its own.
template <class Scalar, instantiate::Family Family>
void append_cells(Cells<Scalar>& cells);

}  // namespace bezierbench::programs
