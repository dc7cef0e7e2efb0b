// SPDX-License-Identifier: MIT
// The targets that this program was built for, whether or not this processor has them.
#pragma once

#include "core/batch/operation_work.hpp"
#include "core/batch/target_table.hpp"

namespace bezierbench::batch {

struct Avx512;
struct Avx2;
struct Neon;

// Each of the following is data, instantiated in a translation unit of its own that is compiled for the target
// (targets/*.in); nothing that it points to may be called on a lesser processor.

/// The kernels of the evaluators that a unit has.
template <class Target, int Unit, class Scalar>
struct UnitOf {
  static const TargetKernels<Scalar>* const table;
};

/// The kernels for many curves.
template <class Target, class Scalar>
struct GroupsOf {
  static const GroupTable<Scalar> table;
};

/// All of them.
template <class Target, class Scalar>
struct TableOf {
  static const TargetTable<Scalar> table;
};

/// The work of single kinds of operations.
template <class Target, class Scalar>
struct WorksOf {
  static const WorksOfWidths<Scalar> table;
};

}  // namespace bezierbench::batch
