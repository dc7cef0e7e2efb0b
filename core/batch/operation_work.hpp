// SPDX-License-Identifier: MIT
// Fixed work of single kinds of operations, in vectors of each width that a target has. The times of this work are
// lower limits for every method with these operations.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/operations/operations.hpp"

namespace bezierbench::batch {

/// Chains that are alike: `values` numbers that a run takes from `first` to `last`.
template <class Scalar>
struct ChainEnds {
  std::size_t values = 0;
  Scalar first = 0;
  Scalar last = 0;
};

/// Chains of operations, each of which waits for the one before in its chain. They load and store nothing between.
template <class Scalar>
struct OperationWork {
  void (*run)(Scalar operand, Scalar* values);
  Scalar operand;
  std::array<ChainEnds<Scalar>, 2> chains;  ///< of one kind, then of another beside it, if there is one
  double operations;                        ///< of a run, on whole vectors
};

/// The work of each kind in vectors of one width.
template <class Scalar>
struct OperationWorks {
  std::size_t lanes;                                                ///< of a vector
  std::array<OperationWork<Scalar>, operation_kinds> side_by_side;  ///< enough chains to hide their latency
  std::array<OperationWork<Scalar>, operation_kinds> one_by_one;    ///< a single chain
  OperationWork<Scalar> multiply_add_and_add;                       ///< additions beside fused multiply-adds
};

/// Narrowest first; the last are the target's full vectors.
template <class Scalar>
using WorksOfWidths = std::span<const OperationWorks<Scalar>>;

}  // namespace bezierbench::batch
